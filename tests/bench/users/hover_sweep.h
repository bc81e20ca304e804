#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "haptic_station/device/hand_driven_device.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/tracking/hover/guided_hand.h"
#include "tests/bench/hand/feed.h"

namespace telepalp::bench {

/// A place in the camera's image [pixels]; the page's pointer as the skin under it is seen.
struct Pixel {
  double u = 0.0;
  double v = 0.0;
};

/// One pointer on the page, one patient and one station with `--tracker browser`, in virtual time. Everything between
/// the pointer's place and the force is the product's own; the page's rule (a hand 0.05 m over the skin under the
/// pointer, which sinks while a button is down) is restated in aim().
class HoverSweep {
 public:
  /// Error: the scene cannot be read, or the patient cannot be made.
  [[nodiscard]] static Result<std::unique_ptr<HoverSweep>> make();

  /// One tick with the pointer at `pointer`.
  void tick(const Pixel& pointer, bool presses);

  struct Seen {
    bool contact = false;  ///< the controller is in a phase in the body
    bool faulted = false;
    double true_depth_m = -1.0;   ///< of the device below the true skin; negative: above it, or not near it
    double from_pointer_m = 1.0;  ///< horizontal distance of the device from the place under the pointer
  };
  [[nodiscard]] const Seen& seen() const noexcept { return seen_; }
  [[nodiscard]] double time_s() const noexcept { return static_cast<double>(ticks_) * kTick_s; }
  void rearm() noexcept { rearm_ = true; }

  static constexpr double kTick_s = 0.0005;

 private:
  HoverSweep(const scenes::Scene& scene, std::shared_ptr<const capture::SyntheticPatient> patient,
             const Transform<HapticBase, DepthCamera>& haptic_from_camera);
  [[nodiscard]] bool see_images();
  [[nodiscard]] std::optional<Point<HapticBase>> aim(const Pixel& pointer, bool presses);
  void judge(const loop::TickOut& out);

  struct Image {
    double arrives_s;
    DepthImage depth;
  };
  std::shared_ptr<const capture::SyntheticPatient> patient_;
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  std::deque<Image> images_;  ///< on their way, then the newest one that has arrived
  hand::Feed feed_;
  loop::TouchableSurface touched_;  ///< kept alive for loop_, which reads it
  loop::HapticLoop loop_;
  device::HandDrivenDevice device_;
  tracking::GuidedHand guided_;
  tracking::SkinHeights heights_;
  std::optional<Point<DepthCamera>> skin_;
  double height_m_;
  Point<HapticBase> wanted_;
  Seen seen_;
  std::int64_t ticks_ = 0;
  bool rearm_ = false;
};

}  // namespace telepalp::bench
