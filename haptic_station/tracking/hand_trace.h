#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "haptic_station/device/simulated_pair.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// One sample of a recorded hand.
struct TraceSample {
  SessionTime at;  ///< time since the trace's first sample
  Point<HandTracker> palm;
  Vector<HandTracker> velocity;  ///< as the tracker measured it [m/s]; zero when the row has no velocity
  std::optional<Eigen::Quaterniond> attitude = {};  ///< from the hand's axes (hand_axes.h) to the tracker's frame
};

/// The samples of a recorded hand, in time order; at least two.
struct HandTrace {
  std::vector<TraceSample> samples;
  std::size_t skipped = 0;  ///< number of rows left out: invalid, out of time order, or of another hand
};

/// Reads a trace as CSV with a header row. Columns may be in any order; unknown ones are ignored. Required:
/// timestamp_us, palm_x_mm, palm_y_mm, palm_z_mm. Optional: vel_x_mm_s, vel_y_mm_s, vel_z_mm_s, hand_id, and
/// the attitude, either as a quaternion qx, qy, qz, qw of the hand's axes, or as the directions nx, ny, nz out of the
/// palm and dx, dy, dz along the fingers. Only the hand of the first valid row is read. Damaged rows, rows out of time
/// order and rows of other hands are skipped and counted. Numbers have a decimal point in every locale. Error: a file
/// over 64 MiB, a required column is missing, or fewer than two valid rows.
[[nodiscard]] Result<HandTrace> read_hand_trace(const std::filesystem::path& file);
[[nodiscard]] Result<HandTrace> parse_hand_trace(std::string_view text, std::string_view name);

/// A simulated person who repeats a recorded movement, alternately forwards and backwards, so that the path is
/// continuous. `haptic_from_tracker` transforms the movement to the haptic base's frame H. The movement is then
/// shifted: its mean position is on the vertical through `skin`, and its lowest point is `depth_m` lower than `skin`.
class RecordedIntention {
 public:
  RecordedIntention(const HandTrace& trace, const Transform<HapticBase, HandTracker>& haptic_from_tracker,
                    const Point<HapticBase>& skin, double depth_m);

  /// The intended position and velocity, `time_s` since the start. No allocation.
  [[nodiscard]] device::Intention at(double time_s) const noexcept;
  /// Rotation from the hand's axes to H, `time_s` since the start; nullopt: the trace has no attitude. No allocation.
  [[nodiscard]] std::optional<Eigen::Quaterniond> attitude(double time_s) const noexcept;
  [[nodiscard]] double duration_s() const noexcept;  ///< of one pass in one direction

 private:
  struct Place {
    std::size_t before;  ///< index of the sample before the queried time
    double share;        ///< elapsed part of the interval to the next sample, 0 to 1
    bool back;           ///< the path is traversed backwards
  };
  [[nodiscard]] Place place(double time_s) const noexcept;

  std::vector<double> times_s_;
  std::vector<Eigen::Vector3d> path_m_;
  std::vector<Eigen::Quaterniond> attitudes_;  ///< one for each sample, or empty
};

}  // namespace telepalp::tracking
