#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "haptic_station/device/simulated_pair.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::tracking {

/// One sample of a recorded hand.
struct TraceSample {
  SessionTime at;  ///< from the trace's first sample
  Point<HandTracker> palm;
  Vector<HandTracker> velocity;  ///< as the tracker gave it [m/s]; zero when the file has none
};

/// A recorded hand, in time order, at least two samples.
struct HandTrace {
  std::vector<TraceSample> samples;
  std::size_t skipped = 0;  ///< rows that could not be used
};

/// Reads a trace as CSV with a header row; columns in any order, others ignored: timestamp_us, palm_x_mm, palm_y_mm,
/// palm_z_mm, and if there are vel_x_mm_s, vel_y_mm_s, vel_z_mm_s and hand_id (the first row's hand is kept).
/// Damaged rows, rows out of time order and other hands are skipped and counted. Numbers use a point whatever the
/// locale. Files over 64 MiB are refused.
[[nodiscard]] Result<HandTrace> read_hand_trace(const std::filesystem::path& file);
[[nodiscard]] Result<HandTrace> parse_hand_trace(std::string_view text, std::string_view name);

/// A person who repeats a recorded movement, there and back so that no jump is left at its ends. `haptic_from_tracker`
/// turns it into H; it is shifted so that its lowest point presses `depth_m` under `skin`.
class RecordedIntention {
 public:
  RecordedIntention(const HandTrace& trace, const Transform<HapticBase, HandTracker>& haptic_from_tracker,
                    const Point<HapticBase>& skin, double depth_m);

  /// `time_s` since the start. No allocation.
  [[nodiscard]] device::Intention at(double time_s) const noexcept;
  [[nodiscard]] double duration_s() const noexcept;  ///< one way

 private:
  std::vector<double> times_s_;
  std::vector<Eigen::Vector3d> path_m_;
};

}  // namespace telepalp::tracking
