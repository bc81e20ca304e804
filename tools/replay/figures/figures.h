#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tools/replay/cell/cell.h"
#include "tools/replay/figures/latency.h"

namespace telepalp::replay {

/// The figures of one run: forces, contact, surface, energy and network. A figure that cannot be computed is NaN, for
/// example because the source has no true skin, or because nothing was touched. A tick is in true contact if the device
/// is over 2 mm deep in the true skin or, where that is unknown, if the unimpaired run is in contact.
struct Figures {
  double seconds = 0.0;
  double force_rmse_N = 0.0;       ///< against the unimpaired run, tick by tick, over all ticks
  double force_p99_N = 0.0;        ///< 99th percentile of the length of this difference
  double force_max_N = 0.0;        ///< largest force
  double force_step_N = 0.0;       ///< largest change of the force from one tick to the next
  double true_force_rmse_N = 0.0;  ///< RMS of TickRecord::off_truth_N: displayed minus true skin's force
  double true_force_p99_N = 0.0;
  double contact_lost_pct = 0.0;     ///< of the ticks in true contact: those without contact
  double phase_differs_pct = 0.0;    ///< of all ticks: those with another phase than in the unimpaired run
  double phase_changes = 0.0;        ///< transitions of the controller
  double released_pct = 0.0;         ///< of all ticks: those at which the station has let go
  double surface_error_rms_m = 0.0;  ///< displayed against true surface, within 45 mm of the skin
  double surface_error_p99_m = 0.0;
  double surface_age_p50_s = 0.0;
  double surface_age_p99_s = 0.0;
  double energy_J = 0.0;       ///< least balance: energy taken from the hand less energy stored; below 0: active
  double hand_excess_J = 0.0;  ///< largest excess in a contact: work on the hand minus that of the measured skin
  double frames = 0.0;         ///< number of frames offered to the network whose deadline has passed
  double frames_in_time_pct = 0.0;
  double frames_touched_pct = 0.0;
  double network_p50_s = 0.0;  ///< from encoded to received, of touched frames
  double network_p99_s = 0.0;
  double station_p50_s = 0.0;  ///< from received to touchable: usable by the haptic loop
  double total_p50_s = 0.0;    ///< from captured to touchable
  double total_p99_s = 0.0;
  double content_B = 0.0;   ///< size of the encoded frames
  double sent_B = 0.0;      ///< sent by the server, with FEC repair packets
  double answered_B = 0.0;  ///< sent by the station
  double datagrams_lost = 0.0;
  LatencyBreakdown latency{};  ///< of the touched frames
};

/// Accumulates the figures of a run, window by window.
class FigureSum {
 public:
  /// `ticks`: of this run. `unimpaired`: the same ticks in the unimpaired run; for that run itself, `ticks` again.
  void add(std::span<const TickRecord> ticks, std::span<const TickRecord> unimpaired);
  void add(const std::vector<FrameTimes>& touchable);
  [[nodiscard]] Figures figures(const Cell& cell) const;

 private:
  void add_force(const TickRecord& tick, const TickRecord& unimpaired);
  void add_contact(const TickRecord& tick, const TickRecord& unimpaired);
  void add_surface(const TickRecord& tick);

  std::uint64_t ticks_ = 0;
  std::uint64_t phase_differs_ = 0;
  std::uint64_t phase_changes_ = 0;
  std::uint64_t released_ = 0;
  std::uint64_t should_feel_ = 0;
  std::uint64_t lost_ = 0;
  double force_max_N_ = 0.0;
  double force_step_N_ = 0.0;
  double least_passivity_J_ = 0.0;
  double largest_excess_J_ = 0.0;
  Eigen::Vector3f last_force_N_ = Eigen::Vector3f::Zero();
  control::Phase last_phase_ = control::Phase::Released;
  std::vector<float> force_off_N_;  // one a tick, for quantiles: 8 kB for a second of session
  std::vector<float> off_truth_N_;
  std::vector<float> surface_off_m_;
  std::vector<float> surface_age_s_;
  std::vector<float> station_s_;
  LatencySum latency_;
};

}  // namespace telepalp::replay
