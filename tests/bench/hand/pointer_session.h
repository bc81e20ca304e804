#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "haptic_station/core/tick_stage.h"
#include "haptic_station/device/joined_rig.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/tracking/protocol/viewer_hand_tracker.h"
#include "tests/bench/hand/feed.h"

namespace telepalp::bench {

/// A place in the camera's image [pixels]. The page's pointer is over the skin that the camera sees there.
struct Pixel {
  double u = 0.0;
  double v = 0.0;
};

/// Delays of the network between the patient's camera, the page and the station.
struct PointerPath {
  double image_s = 0.08;   ///< from an image's exposure until the page and the station have it
  double hand_s = 0.0;     ///< from the page to the station
  double jitter_s = 0.0;   ///< largest extra delay of a hand's message, uniform from 0; messages keep their order
  std::uint64_t seed = 1;  ///< seed of the jitter
};

/// One pointer on the page, one patient and one station with `--device simulated --tracker browser`, in virtual time.
/// Everything between the pointer's place and the force is telepalp's own code. Only the page's rule (a hand 0.05 m
/// over the skin under the pointer, which sinks while a button is down) is restated in aim().
class PointerSession {
 public:
  struct Settings {
    PointerPath path = {};
    std::shared_ptr<const capture::SyntheticPatient> patient = {};  ///< empty: the torso, with the whole image
  };
  /// Error: the scene cannot be read, or the patient cannot be made.
  [[nodiscard]] static Result<std::unique_ptr<PointerSession>> make(const Settings& settings);

  /// One tick with the pointer at `pointer`.
  void tick(const Pixel& pointer, bool presses);
  /// One tick with a hand at `at`, which a headset tracks.
  void tick_tracked(const Point<HapticBase>& at);

  struct Seen {
    bool contact = false;  ///< the controller is in a phase in the body
    bool faulted = false;
    double true_depth_m = -1.0;   ///< depth of the device below the true skin; negative: above it, or not near it
    double from_pointer_m = 1.0;  ///< horizontal distance of the device from the place under the pointer
    Eigen::Vector3d device_m = Eigen::Vector3d::Zero();
    double force_N = 0.0;
    bool saturated = false;  ///< the force is at the limit of position control, or at the device's peak
  };
  [[nodiscard]] const Seen& seen() const noexcept { return seen_; }
  [[nodiscard]] double time_s() const noexcept { return static_cast<double>(ticks_) * kTick_s; }
  void rearm() noexcept { rearm_ = true; }

  static constexpr double kTick_s = 0.0005;

 private:
  class VirtualTracker;
  PointerSession(const Settings& settings, const scenes::Scene& scene,
                 std::shared_ptr<const capture::SyntheticPatient> patient,
                 const Transform<HapticBase, DepthCamera>& haptic_from_camera);
  [[nodiscard]] bool see_images();
  [[nodiscard]] std::optional<Point<HapticBase>> aim(const Pixel& pointer, bool presses);
  void send_hand(const Point<HapticBase>& at, bool hovers);
  void run_tick();
  void deliver_hands();
  void judge(const loop::TickOut& out);

  struct Image {
    double arrives_s;
    DepthImage depth;
  };
  struct SentHand {
    double sent_s;
    double arrives_s;
    Point<HapticBase> at;
    bool hovers;
  };
  Settings settings_;
  control::ControlSettings control_;
  std::shared_ptr<const capture::SyntheticPatient> patient_;
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  std::deque<Image> images_;  ///< the newest one that has arrived, if any has; then those on their way
  std::deque<SentHand> hands_;
  hand::Feed feed_;
  loop::TouchableSurface touched_;  ///< kept alive, because ticks_stage_ reads it
  core::TickStage ticks_stage_;
  std::unique_ptr<device::JoinedRig> rig_;
  tracking::ViewerHandTracker* tracker_ = nullptr;  ///< in `rig_`
  device::Random random_;
  std::optional<Point<DepthCamera>> skin_;
  double height_m_;
  Point<HapticBase> wanted_;
  Seen seen_;
  std::int64_t ticks_ = 0;
  bool rearm_ = false;
};

}  // namespace telepalp::bench
