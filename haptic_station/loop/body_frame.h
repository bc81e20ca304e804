#pragma once

#include <array>

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/surface/touch/touch.h"
#include "proto/words/frames.h"

namespace telepalp::loop {

/// The marks to follow for the objects inside the body: for each object of `effects`, the skin straight above it
/// (along y of the haptic base), in the depth camera's frame.
[[nodiscard]] surface::MarkLines mark_lines(const effects::EffectBank& effects,
                                            const Transform<DepthCamera, HapticBase>& camera_from_haptic) noexcept;

/// How well the place of one object inside the body is known.
struct ObjectPlacement {
  bool watched = false;          ///< false: there is no such object
  bool unseen = false;           ///< the skin above it is not seen: the object stays where it is
  bool slide_unseen = false;     ///< its slide cannot be measured: the object follows the skin's normal motion only
  const char* name = "";         ///< name of the effect
  std::array<float, 3> moved{};  ///< displacement from the place that the scene gives it, in H [m]
  float sigma_normal_m = 0.0F;   ///< 1-sigma along the skin's normal
  float sigma_slide_m = 0.0F;    ///< 1-sigma along the skin, in the least certain direction
};
using ObjectPlacements = std::array<ObjectPlacement, effects::kMostEffects>;

/// The frame of the body: where the objects inside it are displayed. Each object has the displacement of the mark on
/// the skin above it: as measured up to the newest capture, and from then to now predicted along the skin's normal,
/// like the skin. The displayed object follows with the bounded speed and acceleration of the displayed skin, so that
/// it never jumps. When a contact begins with a skin that is shown lower than it was measured, the objects are shown
/// lower by as much, and rise with it. Owner: the haptic thread. Nothing here allocates, locks or throws.
class BodyFrame {
 public:
  explicit BodyFrame(const surface::FollowLimits& limits) noexcept : limits_(limits) {}

  /// A newer snapshot. It must stay alive until the next adopt() or release().
  void adopt(const surface::SurfaceSnapshot& snapshot,
             const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept;
  /// Forgets the snapshot. The objects stay where they are.
  void release() noexcept;

  /// The placements at this tick. `touch`: this tick's result of Touch.
  [[nodiscard]] const effects::Placements& step(const surface::TouchSample& touch, double dt_s) noexcept;

  [[nodiscard]] ObjectPlacements objects() const noexcept;
  [[nodiscard]] bool unseen() const noexcept;        ///< any object
  [[nodiscard]] bool slide_unseen() const noexcept;  ///< any object

 private:
  /// Motion of the skin at a mark since the capture, along the skin's normal.
  struct Carried {
    double m = 0.0;
    double m_per_s = 0.0;
  };
  [[nodiscard]] Carried carried(const surface::SkinMark& mark, double age_s) const noexcept;
  void look_at_one(double age_s) noexcept;

  surface::FollowLimits limits_;
  const surface::SurfaceSnapshot* snapshot_ = nullptr;  // borrowed
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  surface::SkinMarks marks_{};
  std::array<Carried, effects::kMostEffects> carried_{};
  effects::Placements shown_{};
  std::size_t next_look_ = 0;
  bool in_body_ = false;
};

}  // namespace telepalp::loop
