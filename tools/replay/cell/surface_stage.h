#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "codec/depth_stream.h"
#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "tools/replay/cell/station_output.h"
#include "tools/replay/scenario/scenario.h"
#include "tools/replay/scenario/stopwatch.h"
#include "tools/replay/source/tape.h"

namespace telepalp::replay {

/// A depth frame that has arrived at the station.
struct ArrivedDepth {
  std::uint32_t number = 0;
  std::vector<std::byte> bytes{};                    ///< a serialised msg::DepthImage
  std::shared_ptr<const TapeFrame> taped = nullptr;  ///< the frame as it was sent; nullptr: unknown
  SessionTime received{};
};

/// A surface and the frame that it was made from.
struct BuiltSurface {
  loop::TouchableSurface surface;
  FrameTimes times;
  double build_s = 0.0;
};

/// The station's surface thread in virtual time. Frames that arrive while the stage works wait; then the stage
/// builds the newest of them. Decoding and building take the times of the scenario's StageTimes.
class SurfaceStage {
 public:
  SurfaceStage(const StageTimes& stages, const surface::SurfaceSettings& settings,
               const Transform<HapticBase, DepthCamera>& haptic_from_camera, const effects::EffectBank& effects);

  void arrived(ArrivedDepth frame) { waiting_.push_back(std::move(frame)); }
  /// Call it once a tick. Returns the surface that is finished at `now`. Otherwise, if the stage is idle, begins to
  /// decode the newest frame and to build its surface.
  /// `device`: centre of the ball of radius surface::kReach_m in which a surface is built.
  [[nodiscard]] std::optional<BuiltSurface> step(SessionTime now, const Point<HapticBase>& device, Stopwatch& watch);
  /// Frames that could not be decoded, or whose ArrivedDepth::taped is nullptr.
  [[nodiscard]] std::uint64_t undecodable() const noexcept { return undecodable_; }

 private:
  void begin_newest(SessionTime now, const Point<HapticBase>& device, Stopwatch& watch);
  [[nodiscard]] const DepthImage* depth_of(const ArrivedDepth& frame, Stopwatch& watch);

  StageTimes stages_;
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  codec::DepthReader reader_;
  DepthImage decoded_;
  surface::SurfaceBuilder builder_;
  std::deque<ArrivedDepth> waiting_;
  std::optional<BuiltSurface> in_work_;  ///< finished at session time times.touchable_ns
  SessionTime busy_until_{};
  std::uint64_t undecodable_ = 0;
};

}  // namespace telepalp::replay
