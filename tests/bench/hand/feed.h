#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "haptic_station/core/surface_stage.h"
#include "haptic_station/device/random.h"
#include "proto/impaired/gilbert_elliott.h"
#include "server/capture/synthetic/synthetic_patient.h"

namespace telepalp::bench::hand {

/// Delay and jitter of the network, and its losses, which come in bursts (Gilbert and Elliott).
struct Link {
  double one_way_s = 0.05;
  double jitter_s = 0.03;  ///< uniform, in both directions; never more than the delay
  double loss = 0.1;
  std::uint64_t seed = 1;
  double burst_frames = 4.0;  ///< mean number of frames that are lost in a row; 1: independent losses
};

using PoseScript = std::function<capture::PatientPose(double time_s)>;

/// Damages a frame on its way; false: the frame is lost.
using Damage = std::function<bool(double captured_s, DepthImage& depth)>;

/// The camera on the patient, the link, and the station's surface stage. Snapshots are built in the order in which
/// frames arrive. Stations that share the feed may each add a delay.
class Feed {
 public:
  struct Settings {
    std::shared_ptr<const capture::SyntheticPatient> patient;
    PoseScript pose;
    Damage damage = [](double, DepthImage&) { return true; };
    Link link;
    surface::SurfaceSettings builder;
    double frame_hz = 30.0;
    effects::EffectBank effects = {};  ///< the skin above their objects is followed, as by the station
    Transform<HapticBase, DepthCamera> haptic_from_camera = {};  ///< of these objects
  };
  explicit Feed(Settings settings);

  /// The snapshot that became touchable since the last call, if any. Call it once per tick. `device`: centre of the
  /// region that the hand can reach.
  [[nodiscard]] std::shared_ptr<const surface::SurfaceSnapshot> step(double time_s, const Point<DepthCamera>& device);

  /// Time of capture [s] of the newest image that has arrived, even if the builder rejected it; -1 before any image.
  [[nodiscard]] double newest_captured_s() const noexcept { return newest_captured_s_; }

  [[nodiscard]] capture::TrueSurface truth(double time_s) const {
    return settings_.patient->surface_of(settings_.pose(time_s));
  }
  [[nodiscard]] const Settings& settings() const noexcept { return settings_; }

 private:
  struct Frame {
    double captured_s;
    double arrives_s;
    DepthImage depth;
  };
  void capture(double time_s);

  Settings settings_;
  double newest_captured_s_ = -1.0;
  core::SurfaceStage stage_;
  device::Random random_;
  std::deque<Frame> on_the_way_;  ///< ordered by arrival
  std::int64_t frames_ = 0;
  impaired::GilbertElliott loss_;
};

[[nodiscard]] inline SessionTime at_time(double seconds) { return session_time(0) + from_seconds(seconds); }

}  // namespace telepalp::bench::hand
