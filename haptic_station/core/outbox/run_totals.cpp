#include "haptic_station/core/outbox/run_totals.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/loop/tick.h"
#include "proto/wire/station/contact_force.h"

namespace telepalp::core {
namespace {

constexpr double kPeriod_s = std::chrono::duration<double>(loop::kTickPeriod).count();

double norm(const std::array<float, 3>& v) noexcept { return std::hypot(double{v[0]}, double{v[1]}, double{v[2]}); }

}  // namespace

RunTotals::Change RunTotals::add(const loop::TickSample& sample) {
  const Change change{.phase_changed = ticks_ == 0 || sample.phase != phase_, .from = phase_};
  phase_ = sample.phase;
  Dwell& dwell = dwell_[sample.phase];
  if (change.phase_changed) ++dwell.entries;
  ++dwell.ticks;
  ++ticks_;
  if (wire::is_contact(static_cast<msg::Phase>(sample.phase))) ++contact_ticks_;
  work_.add(static_cast<std::uint64_t>(std::max(0.0F, sample.work_us) * 1000.0F));
  force_max_N_ = std::max(force_max_N_, norm(sample.force));
  return change;
}

msg::StationStats RunTotals::message() const {
  msg::StationStats stats;
  stats.set_ticks(ticks_);
  stats.set_tick_us_p50(work_.quantile_ns(0.5) * 1e-3);
  stats.set_tick_us_p99(work_.quantile_ns(0.99) * 1e-3);
  stats.set_tick_us_p999(work_.quantile_ns(0.999) * 1e-3);
  stats.set_frames_received(frames_received_);
  for (const auto& [phase, dwell] : dwell_) {
    msg::PhaseDwell& row = *stats.add_phases();
    row.set_phase(static_cast<msg::Phase>(phase));
    row.set_entries(dwell.entries);
    row.set_seconds(static_cast<double>(dwell.ticks) * kPeriod_s);
  }
  stats.set_contact_s(static_cast<double>(contact_ticks_) * kPeriod_s);
  stats.set_force_max_n(force_max_N_);
  return stats;
}

}  // namespace telepalp::core
