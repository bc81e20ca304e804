#include "tools/replay/figures/figures.h"

#include <algorithm>
#include <cmath>

#include "tools/replay/figures/quantile.h"

namespace telepalp::replay {
namespace {

constexpr float kSurelyInside_m = 0.002F;  // deeper than the sensor's error
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double rms(const std::vector<float>& values) {
  double square = 0.0;
  for (const float value : values) square += double{value} * double{value};
  return values.empty() ? kNaN : std::sqrt(square / static_cast<double>(values.size()));
}

double percent(std::uint64_t part, std::uint64_t of) {
  return of == 0 ? kNaN : 100.0 * static_cast<double>(part) / static_cast<double>(of);
}

}  // namespace

void FigureSum::add_force(const TickRecord& tick, const TickRecord& unimpaired) {
  force_off_N_.push_back((tick.force_N - unimpaired.force_N).norm());
  force_max_N_ = std::max(force_max_N_, double{tick.force_N.norm()});
  force_step_N_ = std::max(force_step_N_, double{(tick.force_N - last_force_N_).norm()});
  last_force_N_ = tick.force_N;
  if (std::isfinite(tick.off_truth_N)) off_truth_N_.push_back(tick.off_truth_N);
  least_passivity_J_ = std::min(least_passivity_J_, double{tick.passivity_J});
  largest_excess_J_ = std::max(largest_excess_J_, double{tick.hand_excess_J});
}

/// Whether the skin should be felt: decided by the true skin or, where it is unknown, by the unimpaired run.
void FigureSum::add_contact(const TickRecord& tick, const TickRecord& unimpaired) {
  const bool should = std::isfinite(tick.depth_m) ? tick.depth_m > kSurelyInside_m : unimpaired.felt;
  if (should) ++should_feel_;
  if (should && !tick.felt) ++lost_;
  if (tick.phase != unimpaired.phase) ++phase_differs_;
  if (tick.phase != last_phase_) ++phase_changes_;
  if (control::has_let_go(tick.phase)) ++released_;
  last_phase_ = tick.phase;
}

void FigureSum::add_surface(const TickRecord& tick) {
  if (std::isfinite(tick.surface_off_m)) surface_off_m_.push_back(tick.surface_off_m);
  if (std::isfinite(tick.surface_age_s)) surface_age_s_.push_back(tick.surface_age_s);
}

void FigureSum::add(std::span<const TickRecord> ticks, std::span<const TickRecord> unimpaired) {
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ++ticks_;
    add_force(ticks[i], unimpaired[i]);
    add_contact(ticks[i], unimpaired[i]);
    add_surface(ticks[i]);
  }
}

void FigureSum::add(const std::vector<FrameTimes>& touchable) {
  for (const FrameTimes& times : touchable) {
    latency_.add(times);
    station_s_.push_back(seconds_between(times.received_ns, times.touchable_ns));
  }
}

Figures FigureSum::figures(const Cell& cell) const {
  const FrameCounts frames = cell.frames();
  const PathCounts& path = cell.path();
  const LatencyBreakdown latency = latency_.breakdown();
  const StageLatency& network = latency[kNetworkStage];
  const StageLatency& total = latency[kTotalStage];
  return {.seconds = static_cast<double>(ticks_) * to_seconds(kTick),
          .force_rmse_N = rms(force_off_N_),
          .force_p99_N = quantile(force_off_N_, 0.99),
          .force_max_N = force_max_N_,
          .force_step_N = force_step_N_,
          .true_force_rmse_N = rms(off_truth_N_),
          .true_force_p99_N = quantile(off_truth_N_, 0.99),
          .contact_lost_pct = percent(lost_, should_feel_),
          .phase_differs_pct = percent(phase_differs_, ticks_),
          .phase_changes = static_cast<double>(phase_changes_),
          .released_pct = percent(released_, ticks_),
          .surface_error_rms_m = rms(surface_off_m_),
          .surface_error_p99_m = quantile(surface_off_m_, 0.99),
          .surface_age_p50_s = quantile(surface_age_s_, 0.5),
          .surface_age_p99_s = quantile(surface_age_s_, 0.99),
          .energy_J = least_passivity_J_,
          .hand_excess_J = largest_excess_J_,
          .frames = static_cast<double>(frames.offered),
          .frames_in_time_pct = percent(frames.in_time, frames.offered),
          .frames_touched_pct = percent(frames.touched, frames.offered),
          .network_p50_s = network.p50_s,
          .network_p99_s = network.p99_s,
          .station_p50_s = quantile(station_s_, 0.5),
          .total_p50_s = total.p50_s,
          .total_p99_s = total.p99_s,
          .content_B = static_cast<double>(frames.offered_B),
          .sent_B = static_cast<double>(path.sent_B),
          .answered_B = static_cast<double>(path.answered_B),
          .datagrams_lost = static_cast<double>(path.lost),
          .latency = latency};
}

}  // namespace telepalp::replay
