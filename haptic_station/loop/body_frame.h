#pragma once

#include <array>

#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/surface/touch/touch.h"
#include "proto/words/frames.h"

namespace telepalp::loop {

/// The lines on which surface::MarkTracker finds the skin above the objects inside the body: one line for each object
/// of `effects`, through the object and along y of the haptic base, in the depth camera's frame.
[[nodiscard]] surface::MarkLines mark_lines(const effects::EffectBank& effects,
                                            const Transform<DepthCamera, HapticBase>& camera_from_haptic) noexcept;

/// How well the place of one object inside the body is known.
struct ObjectPlacement {
  bool watched = false;          ///< false: this entry has no object
  bool unseen = false;           ///< the camera does not see the skin above the object: the object stays where it is
  bool slide_unseen = false;     ///< the skin's tangential motion (slide) cannot be measured: the last slide is held
  const char* name = "";         ///< name of the effect; BodyFrame leaves it empty, and HapticLoop fills it in
  std::array<float, 3> moved{};  ///< displacement from its place in the scene, in the haptic base's frame H [m]
  float sigma_normal_m = 0.0F;   ///< 1-sigma of the displacement along the skin's normal
  float sigma_slide_m = 0.0F;    ///< 1-sigma along the skin, in the least certain direction
};
using ObjectPlacements = std::array<ObjectPlacement, effects::kMostEffects>;

/// Computes where the objects inside the body are displayed. The target of each object is the displacement of the mark
/// (a followed point of the skin) above it: measured up to the newest capture, then predicted to now along the skin's
/// normal. The displayed object approaches its target with bounded speed and acceleration. If a contact begins while
/// the skin is displayed lower than measured, the objects are at once displayed lower by the same distance and rise
/// with the skin. An object whose mark is not seen is not lowered if the contact is on the outer side of the skin that
/// was last seen over this object. Owner: the haptic thread. Nothing here allocates, locks or throws.
class BodyFrame {
 public:
  explicit BodyFrame(const surface::FollowLimits& limits) noexcept : limits_(limits) {}

  /// Uses a newer snapshot. The snapshot must stay alive until the next adopt() or release().
  void adopt(const surface::SurfaceSnapshot& snapshot,
             const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept;
  /// Forgets the snapshot. The objects stay where they are.
  void release() noexcept;

  /// The placements at this tick. `touch`: the result of surface::Touch at this tick.
  [[nodiscard]] const effects::Placements& step(const surface::TouchSample& touch, double dt_s) noexcept;

  [[nodiscard]] ObjectPlacements objects() const noexcept;
  [[nodiscard]] bool unseen() const noexcept { return unseen_; }  ///< ObjectPlacement::unseen of any object
  /// ObjectPlacement::slide_unseen of any object.
  [[nodiscard]] bool slide_unseen() const noexcept { return slide_unseen_; }

 private:
  /// Motion of the skin at a mark since the capture, along the skin's normal.
  struct Carried {
    double m = 0.0;
    double m_per_s = 0.0;
  };
  [[nodiscard]] Carried carried(const surface::SkinMark& mark, double age_s) const noexcept;
  [[nodiscard]] effects::Placement target(std::size_t object) const noexcept;
  void look_at_one(double age_s) noexcept;
  void lower_with_skin(const surface::TouchSample& touch) noexcept;
  void note_unseen() noexcept;

  surface::FollowLimits limits_;
  const surface::SurfaceSnapshot* snapshot_ = nullptr;  // borrowed
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  surface::SkinMarks marks_{};
  std::array<Carried, effects::kMostEffects> carried_{};
  effects::Placements shown_{};
  surface::FollowShare share_;
  std::size_t next_look_ = 0;
  bool watched_ = false;  ///< there is an object; this and the next two summarise `marks_`
  bool unseen_ = false;
  bool slide_unseen_ = false;
  bool in_body_ = false;
};

}  // namespace telepalp::loop
