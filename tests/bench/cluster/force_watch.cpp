#include "tests/bench/cluster/force_watch.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/core/built_effects.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"

namespace telepalp::bench {
namespace {

constexpr double kPunctual = 0.1;      // of a period: a tick that is so little late counts as in time
constexpr int kMostInserted = 20'000;  // 10 s without a tick

replay::TickRecord tick_of(const msg::StationTicks& ticks, int i) {
  const auto phase = static_cast<control::Phase>(ticks.phase(i));  // the values are the same
  return {.force_N = {ticks.force_x(i), ticks.force_y(i), ticks.force_z(i)},
          .device_m = {double{ticks.device_x(i)}, double{ticks.device_y(i)}, double{ticks.device_z(i)}},
          .phase = phase,
          .touching = (control::is_inside(phase) || phase == control::Phase::BodyToPlane) && ticks.distance_m(i) < 0.0F,
          .surface_age_s = ticks.surface_age_s(i)};
}

bool is_whole(const msg::StationTicks& ticks) {
  for (const int size :
       {ticks.force_x_size(), ticks.force_y_size(), ticks.force_z_size(), ticks.device_x_size(), ticks.device_y_size(),
        ticks.device_z_size(), ticks.distance_m_size(), ticks.hand_age_s_size(), ticks.surface_age_s_size()})
    if (size != ticks.phase_size()) return false;
  return true;
}

}  // namespace

ForceWatch::ForceWatch(const scenes::Scene& scene)
    : invariants_({}, scene.control, core::bank_of(scene.effects).stiffest_N_per_m(scene.control.limits.peak_N)) {}

void ForceWatch::judge(const replay::TickRecord& tick, std::uint64_t periods) {
  for (std::uint64_t i = 1; i < periods; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(periods);
    replay::TickRecord between = tick;
    between.force_N = last_.force_N + share * (tick.force_N - last_.force_N);
    between.device_m = last_.device_m + double{share} * (tick.device_m - last_.device_m);
    invariants_.add(between);
  }
  invariants_.add(tick);
  last_ = tick;
  facts_.violation = invariants_.violation();
}

/// A thread that wakes too late skips periods, which have no tick and no number. The inputs' ages tell how many, unless
/// both begin anew in the same tick.
std::uint64_t ForceWatch::periods_until(const msg::StationTicks& ticks, int i) {
  const Ages now{.surface_s = double{ticks.surface_age_s(i)}, .hand_s = double{ticks.hand_age_s(i)}};
  const double period_s = 1e-9 * ticks.period_ns();
  const double older_s = std::max(now.surface_s - ages_.surface_s, now.hand_s - ages_.hand_s);
  const double between_s =
      i == 0 ? 1e-9 * (static_cast<double>(ticks.first_tick_ns()) - next_tick_ns_) + period_s : 0.0;
  ages_ = now;
  const double periods = std::max(std::isfinite(older_s) ? older_s : 0.0, between_s) / period_s;
  return static_cast<std::uint64_t>(
      std::clamp(std::ceil(periods - kPunctual), 1.0, static_cast<double>(kMostInserted)));
}

void ForceWatch::add(const msg::StationTicks& ticks) {
  if (!is_whole(ticks) || ticks.period_ns() == 0) return;
  if (facts_.ticks == 0) next_tick_ns_ = static_cast<double>(ticks.first_tick_ns());
  if (facts_.ticks > 0 && ticks.first_tick() > next_tick_) facts_.missing += ticks.first_tick() - next_tick_;
  const int count = ticks.phase_size();
  for (int i = 0; i < count; ++i) {
    const replay::TickRecord tick = tick_of(ticks, i);
    judge(tick, periods_until(ticks, i));
    ++facts_.ticks;
    facts_.touching += tick.touching ? 1 : 0;
    facts_.faults += tick.phase == control::Phase::Faulted ? 1 : 0;
    facts_.most_N = std::max(facts_.most_N, double{tick.force_N.norm()});
  }
  next_tick_ = ticks.first_tick() + static_cast<std::uint64_t>(count);
  next_tick_ns_ = static_cast<double>(ticks.first_tick_ns()) + static_cast<double>(count) * ticks.period_ns();
}

void ForceWatch::add(const wire::Message& message) {
  if (message.topic.name == wire::kStationTicks.name) {
    msg::StationTicks ticks;
    if (ticks.ParseFromString(*message.payload)) add(ticks);
  } else if (message.topic.name == wire::kStationEvents.name) {
    msg::StationEvent event;
    if (event.ParseFromString(*message.payload) && event.kind() == msg::EVENT_KIND_FAULT) ++facts_.faults;
  }
}

Result<ForceFacts> force_facts(const std::filesystem::path& session) {
  const Result<std::filesystem::path> file = scenes::find_scene("palpation");
  if (!file) return file.error();
  const Result<scenes::Scene> scene = scenes::read_scene(*file);
  if (!scene) return scene.error();
  Result<wire::McapReader> reader = wire::McapReader::open(session);
  if (!reader) return reader.error();
  ForceWatch watch(*scene);
  for (;;) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!message.value()) return watch.facts();
    watch.add(**message);
  }
}

}  // namespace telepalp::bench
