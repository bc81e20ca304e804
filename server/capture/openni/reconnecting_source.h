#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/openni/camera_device.h"
#include "server/capture/openni/timestamp_map.h"

namespace telepalp::capture {

/// States and events of a camera that may be unplugged.
enum class CameraPhase : std::uint8_t { Waiting, Live, Lost, Ended };
enum class CameraEvent : std::uint8_t { FrameCame, FellSilent, WentAway, CameBack, RecordingEnded };

struct CameraRow {
  CameraPhase from;
  CameraEvent on;
  CameraPhase to;
};

inline constexpr CameraRow kCameraTransitions[] = {
    {CameraPhase::Waiting, CameraEvent::FrameCame, CameraPhase::Live},
    {CameraPhase::Waiting, CameraEvent::FellSilent, CameraPhase::Lost},
    {CameraPhase::Waiting, CameraEvent::WentAway, CameraPhase::Lost},
    {CameraPhase::Waiting, CameraEvent::RecordingEnded, CameraPhase::Ended},
    {CameraPhase::Live, CameraEvent::FellSilent, CameraPhase::Lost},
    {CameraPhase::Live, CameraEvent::WentAway, CameraPhase::Lost},
    {CameraPhase::Live, CameraEvent::RecordingEnded, CameraPhase::Ended},
    {CameraPhase::Lost, CameraEvent::CameBack, CameraPhase::Waiting},
};

/// The next state; a pair that is not in the table leaves the state unchanged.
[[nodiscard]] constexpr CameraPhase next(CameraPhase phase, CameraEvent event) noexcept {
  for (const CameraRow& row : kCameraTransitions)
    if (row.from == phase && row.on == event) return row.to;
  return phase;
}

/// Clock and sleep of the reconnecting source: the session clock, or a simulated clock in tests.
struct SourceTime {
  std::function<SessionTime()> now;
  std::function<void(Nanoseconds)> sleep;
};

/// A camera that may be unplugged. While the camera is lost, the source tries to open it once a second; state() and
/// detail() report the loss. Driver time stamps are mapped to session time.
class ReconnectingSource final : public CaptureSource {
 public:
  static constexpr Nanoseconds kSilence{2'000'000'000};  ///< after this time without a frame, the camera is lost
  static constexpr Nanoseconds kRetry{1'000'000'000};    ///< time between two attempts to open the lost camera

  /// `device` must be open.
  ReconnectingSource(std::unique_ptr<CameraDevice> device, SourceTime time);

  std::optional<RgbdFrame> next(Nanoseconds patience) override;
  [[nodiscard]] CaptureState state() const override;
  [[nodiscard]] std::string detail() const override;
  [[nodiscard]] std::optional<ExposureLimits> exposure_limits() const override;
  [[nodiscard]] Exposure exposure() const override;
  [[nodiscard]] Result<void> set_exposure(const Exposure& exposure) override;

 private:
  void lose(CameraEvent event, const std::string& why);
  void try_again(Nanoseconds patience);
  RgbdFrame stamped(CameraDevice::Frame frame);

  std::unique_ptr<CameraDevice> device_;
  SourceTime time_;
  TimestampMap timestamps_;
  CameraPhase phase_ = CameraPhase::Waiting;
  SessionTime last_sign_;  // when the last frame arrived or the device was opened
  SessionTime last_try_;
  std::string why_lost_;
  std::optional<Exposure> wanted_;  // set last; nullopt: as the camera had it
  std::uint64_t sequence_ = 0;
  std::uint64_t times_lost_ = 0;
};

}  // namespace telepalp::capture
