#pragma once

namespace telepalp::mixed {

/// Whether the device is hidden. Paper S3 hides it always. Here it is shown when the picture cannot be trusted,
/// because a hidden machine that moves is then a danger.
enum class Camouflage { Visible, Hiding, Hidden, Revealing };
enum class PictureEvent { Trusted, Doubted, FadeEnded };

struct CamouflageRow {
  Camouflage from;
  PictureEvent on;
  Camouflage to;
};
inline constexpr CamouflageRow kCamouflageTable[] = {
    {Camouflage::Visible, PictureEvent::Trusted, Camouflage::Hiding},
    {Camouflage::Hiding, PictureEvent::FadeEnded, Camouflage::Hidden},
    {Camouflage::Hiding, PictureEvent::Doubted, Camouflage::Revealing},
    {Camouflage::Hidden, PictureEvent::Doubted, Camouflage::Revealing},
    {Camouflage::Revealing, PictureEvent::FadeEnded, Camouflage::Visible},
    {Camouflage::Revealing, PictureEvent::Trusted, Camouflage::Hiding},
};
/// A pair that is not listed changes nothing.
[[nodiscard]] constexpr Camouflage next(Camouflage phase, PictureEvent event) noexcept {
  for (const CamouflageRow& row : kCamouflageTable)
    if (row.from == phase && row.on == event) return row.to;
  return phase;
}

/// What decides whether the picture is trusted or doubted, at one image of the camera.
struct PictureTrust {
  bool fault = false;        ///< any fault of the station
  bool markers_seen = true;  ///< the camera's pose is known
  double image_age_s = 0.0;  ///< since the camera's exposure; not a number: no image yet
};

/// How strongly the device is hidden. Owner: the thread that draws.
struct CamouflageState {
  Camouflage phase = Camouflage::Visible;
  double opacity = 0.0;        ///< of the background over the device, 0 to 1
  double trusted_for_s = 0.0;  ///< time with young images since the last doubt
};

inline constexpr double kOldImage_s = 0.25;    ///< an older image reveals the device at once
inline constexpr double kFreshImage_s = 0.15;  ///< only the time with younger images counts as trusted
inline constexpr double kTrustAfter_s = 0.5;   ///< the device is hidden after this time of trusted pictures
inline constexpr double kHideIn_s = 0.4;       ///< length of the fade that hides the device
inline constexpr double kRevealIn_s = 0.1;     ///< length of the fade that shows the device again

/// The state after `step_s`. Pure: no clock.
[[nodiscard]] CamouflageState advance(CamouflageState state, const PictureTrust& trust, double step_s) noexcept;

/// Opacity of the device's ghost, 0 to 1: it appears as a joint comes near the end of its range, where the hidden
/// device stops. `joint_share`: distance from an end of its range, as a share of the range, of the joint nearest to an
/// end.
[[nodiscard]] double ghost_opacity(double joint_share) noexcept;

}  // namespace telepalp::mixed
