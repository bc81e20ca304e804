#include "clients/report/summary/summary.h"

#include <algorithm>
#include <cmath>

#include "clients/ar/messages/phases.h"
#include "proto/wire/datagrams/images_way.h"
#include "proto/wire/station/contact_force.h"
#include "proto/wire/topics.h"

namespace telepalp::report {
namespace {

double mean_rate(std::size_t events, std::int64_t first_ns, std::int64_t last_ns) {
  return events < 2 || last_ns <= first_ns
             ? kUnknown
             : static_cast<double>(events - 1) / to_seconds(Nanoseconds(last_ns - first_ns));
}

double mean_rate(std::vector<std::int64_t> at_ns) {
  if (at_ns.empty()) return kUnknown;
  const auto [first, last] = std::minmax_element(at_ns.begin(), at_ns.end());
  return mean_rate(at_ns.size(), *first, *last);
}

double ms_between(std::uint64_t from_ns, std::uint64_t to_ns) {
  if (from_ns == 0 || to_ns == 0) return kUnknown;  // 0: this stage was not stamped
  return static_cast<double>(static_cast<std::int64_t>(to_ns - from_ns)) * 1e-6;
}

template <class Proto, class Take>
Quantiles over(const std::vector<Proto>& messages, Take take) {
  std::vector<double> values;
  values.reserve(messages.size());
  for (const Proto& message : messages) values.push_back(take(message));
  return quantiles(std::move(values));
}

void add_latencies(Summary& summary, const Session& session) {
  using Surface = msg::SurfaceReport;
  const auto& all = session.surfaces;
  summary.capture_to_encoded_ms =
      over(all, [](const Surface& s) { return ms_between(s.captured_ns(), s.encoded_ns()); });
  summary.encoded_to_received_ms =
      over(all, [](const Surface& s) { return ms_between(s.encoded_ns(), s.received_ns()); });
  summary.received_to_decoded_ms =
      over(all, [](const Surface& s) { return ms_between(s.received_ns(), s.decoded_ns()); });
  summary.decoded_to_touchable_ms =
      over(all, [](const Surface& s) { return ms_between(s.decoded_ns(), s.touchable_ns()); });
  summary.capture_to_touchable_ms =
      over(all, [](const Surface& s) { return ms_between(s.captured_ns(), s.touchable_ns()); });
  summary.clock_error_ms =
      over(all, [](const Surface& s) { return s.clock_error_s() > 0.0 ? 1e3 * s.clock_error_s() : kUnknown; });
  std::vector<double> ages;
  for (const msg::StationState& state : session.states)
    ages.push_back(ms_between(state.surface_captured_ns(), state.stamp_ns()));
  summary.surface_age_ms = quantiles(std::move(ages));
}

void add_compensation(Summary& summary, const Session& session) {
  using Sample = msg::StationCompensation;
  const auto& all = session.compensations;
  summary.surface_carried_mm = over(all, [](const Sample& t) { return std::abs(t.surface_carried_m()) * 1e3; });
  summary.assumed_age_ms = over(all, [](const Sample& t) { return t.surface_age_s() * 1e3; });
  summary.hand_carried_mm = over(all, [](const Sample& t) { return t.hand_carried_m() * 1e3; });
  if (all.empty()) return;
  const auto share = [&](auto flagged) {
    const auto count = std::count_if(all.begin(), all.end(), [&](const Sample& sample) {
      return std::any_of(sample.objects().begin(), sample.objects().end(), flagged);
    });
    return static_cast<double>(count) / static_cast<double>(all.size());
  };
  summary.object_unseen_share = share([](const msg::ObjectPlacement& object) { return object.unseen(); });
  summary.unmodelled_share =
      static_cast<double>(std::count_if(all.begin(), all.end(), [](const Sample& s) { return s.unmodelled() > 0.5; })) /
      static_cast<double>(all.size());
  summary.object_slide_unseen_share = share([](const msg::ObjectPlacement& object) { return object.slide_unseen(); });
}

void add_energy(Summary& summary, const Session& session) {
  using State = msg::StationState;
  summary.display_least_mJ = -over(session.states, [](const State& s) { return -1e3 * s.passivity_j(); }).most;
  summary.hand_excess_most_mJ = over(session.states, [](const State& s) { return 1e3 * s.hand_excess_j(); }).most;
  summary.heat_warnings = static_cast<std::uint64_t>(
      std::count_if(session.events.begin(), session.events.end(),
                    [](const msg::StationEvent& event) { return event.kind() == msg::EVENT_KIND_HEAT; }));
}

std::size_t index_of(msg::Phase phase) { return static_cast<std::size_t>(&ar::words_for(phase) - ar::kPhases.data()); }

/// Dwell times from the ticks. A gap in the recording adds no time.
void add_dwells(Summary& summary, const Ticks& ticks) {
  const double period_s = ticks.period_ns * 1e-9;
  bool contact_before = false;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::size_t phase = index_of(ticks.phase[i]);
    Dwell& dwell = summary.dwells[phase];
    if (i == 0 || ticks.phase[i] != ticks.phase[i - 1]) ++dwell.entries;
    dwell.seconds += period_s;
    const bool contact = wire::is_contact(ticks.phase[i]);
    if (contact) summary.contact_s += period_s;
    if (contact && !contact_before) ++summary.touches;
    contact_before = contact;
  }
}

void add_dwells(Summary& summary, const msg::StationStats& stats) {
  for (const msg::PhaseDwell& dwell : stats.phases())
    summary.dwells[index_of(dwell.phase())] = {dwell.entries(), dwell.seconds()};
  summary.contact_s = stats.contact_s();
}

std::uint64_t count_non_finite(const Ticks& ticks) {
  std::uint64_t count = 0;
  const auto add = [&](const std::vector<float>& column) {
    count += static_cast<std::uint64_t>(
        std::count_if(column.begin(), column.end(), [](float value) { return !std::isfinite(value); }));
  };
  for (const Axes* axes : {&ticks.hand, &ticks.device, &ticks.proxy, &ticks.force})
    for (const std::vector<float>& column : *axes) add(column);
  add(ticks.indentation_m);
  add(ticks.distance_m);
  return count;
}

/// Number of recorded ticks that ended after the next one was due. It is the count of missed deadlines unless the
/// station's own count is known: the station also counts deadlines whose ticks it skipped.
std::uint64_t count_overruns(const Ticks& ticks) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i)
    if (ticks.late_us[i] + ticks.work_us[i] > static_cast<float>(ticks.period_ns) * 1e-3F) ++count;
  return count;
}

double greatest(const std::vector<double>& values) { return quantiles(values).most; }

void add_ticks(Summary& summary, const Ticks& ticks) {
  summary.ticks = ticks.size();
  summary.tick_us = quantiles({ticks.work_us.begin(), ticks.work_us.end()});
  summary.lateness_us = quantiles({ticks.late_us.begin(), ticks.late_us.end()});
  const std::uint64_t made = ticks.last_number - ticks.first_number + 1;  // wraps if the station restarted
  const bool numbered = ticks.last_number > ticks.first_number && made >= ticks.size();
  summary.ticks_per_s = numbered ? mean_rate(made, ticks.at_ns.front(), ticks.at_ns.back()) : mean_rate(ticks.at_ns);
  if (numbered) summary.ticks_missing = made - ticks.size();
  std::vector<double> force_N = force_norm_N(ticks);
  summary.force_max_N = greatest(force_N);
  std::vector<double> drive_N = force_N;
  for (std::size_t i = 0; i < force_N.size(); ++i) (wire::is_contact(ticks.phase[i]) ? drive_N : force_N)[i] = kUnknown;
  summary.force_in_contact_max_N = greatest(force_N);
  summary.force_of_drive_max_N = greatest(drive_N);
  summary.indentation_max_mm = 1e3 * greatest({ticks.indentation_m.begin(), ticks.indentation_m.end()});
  summary.non_finite = count_non_finite(ticks);
  summary.deadlines_missed = count_overruns(ticks);
  add_dwells(summary, ticks);
}

/// Adds the station's own counts. What the ticks give stays, except the count of missed deadlines where the station's
/// count covers the recording. Without ticks, all values are the station's.
void add_stats(Summary& summary, const Session& session) {
  if (!session.station_stats) return;
  const msg::StationStats& stats = *session.station_stats;
  if (session.deadlines_missed.is_known()) summary.deadlines_missed = session.deadlines_missed.in_recording();
  summary.telemetry_dropped = session.telemetry_dropped.in_recording();
  if (stats.has_idle_timer()) summary.idle_timer = {stats.idle_timer().wakeups(), stats.idle_timer().missed()};
  summary.realtime = stats.realtime();
  summary.bill.assign(stats.bill().begin(), stats.bill().end());
  if (session.ticks.size() > 0) return;
  summary.ticks = stats.ticks();
  summary.tick_us = {stats.tick_us_p50(), stats.tick_us_p99(), stats.tick_us_p999(), kUnknown, stats.ticks()};
  summary.force_max_N = stats.force_max_n();
  add_dwells(summary, stats);
}

wire::DepthFidelity depth_of(const Session& session) {
  wire::DepthFidelity touched;
  for (const msg::SurfaceReport& surface : session.surfaces)
    touched = wire::less_exact(touched, wire::depth_fidelity(surface));
  return touched.mode.empty() && !touched.moved ? session.depth : touched;
}

/// True if the subscription is the sender's. A session of an older server contains only the names that programs give
/// themselves; a viewer may be called "workstation 3".
bool is_of(const Subscription& subscription, std::uint32_t sender) {
  constexpr std::string_view kStation = "telepalp-station";
  return sender != 0 ? subscription.sender == sender : subscription.name == kStation;
}

/// Adds the frames of all connections of the sender, because it may have reconnected.
void add_frames(SenderSummary& summary, const Session& session, const SenderRecord& record) {
  if (record.station_stats) {
    summary.frames_received = record.frames_received.in_recording();
    summary.frames_unused = record.frames_dropped.in_recording();
    summary.received_until_ns = record.counted_ns;
  }
  for (const auto& [key, subscription] : session.subscriptions) {
    if (!is_of(subscription, record.sender)) continue;
    const bool whole = subscription.was_there_first && record.began_here;
    summary.name = subscription.name;
    summary.address = subscription.address;
    summary.frames_sent = summary.frames_sent.value_or(0) + subscription.depth_sent.in_recording() +
                          (whole ? subscription.depth_sent_before : 0);
    summary.frames_dropped = summary.frames_dropped.value_or(0) + subscription.depth_dropped.in_recording() +
                             (whole ? subscription.depth_dropped_before : 0);
    summary.sent_until_ns = std::max(summary.sent_until_ns, subscription.counted_ns);
    summary.carriers.insert(summary.carriers.end(), subscription.carriers.begin(), subscription.carriers.end());
    summary.shared_line.add(subscription.shared_line);
  }
  std::sort(summary.carriers.begin(), summary.carriers.end(),
            [](const Carrier& one, const Carrier& other) { return one.since_ns < other.since_ns; });
}

/// Server and station each publish their counts once a second, at different times, and a frame is on the way for its
/// time in the network: so the station's last count lacks the frames of the time between.
std::uint64_t frames_on_the_way(const Summary& summary, const SenderSummary& station) {
  if (!station.frames_sent || !station.frames_received || *station.frames_sent <= *station.frames_received) return 0;
  const double network_s = 1e-3 * summary.encoded_to_received_ms.p50;
  const double later_s = to_seconds(Nanoseconds(station.sent_until_ns - station.received_until_ns));
  const double frames = summary.camera_depth_per_s * (later_s + network_s);
  if (!(frames > 0.0)) return 0;
  return std::min(static_cast<std::uint64_t>(std::llround(frames)), *station.frames_sent - *station.frames_received);
}

std::uint64_t touches_of(const Ticks& ticks) {
  std::uint64_t touches = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i)
    if (wire::is_contact(ticks.phase[i]) && (i == 0 || !wire::is_contact(ticks.phase[i - 1]))) ++touches;
  return touches;
}

SenderSummary sender_summary(const Session& session, const SenderRecord& record) {
  SenderSummary summary;
  summary.sender = record.sender;
  summary.messages = record.sent_messages;
  summary.ticks = record.ticks.size();
  summary.states = record.states.size();
  summary.touches = touches_of(record.ticks);
  summary.force_max_N = greatest(force_norm_N(record.ticks));
  add_frames(summary, session, record);
  return summary;
}

void add_senders(Summary& summary, const Session& session) {
  if (session.sent_messages > 0) summary.senders.push_back(sender_summary(session, session));
  for (const auto& [sender, other] : session.others) summary.senders.push_back(sender_summary(session, other));
  if (summary.senders.empty()) return;
  const SenderSummary& judged = summary.senders.front();
  summary.frames_sent = judged.frames_sent;
  summary.frames_received = judged.frames_received;
  summary.frames_dropped = judged.frames_dropped;
  summary.frames_unused = judged.frames_unused;
  summary.frames_on_the_way = frames_on_the_way(summary, judged);
  summary.carriers = judged.carriers;
  summary.shared_line = judged.shared_line;
}

void add_ways(Summary& summary, const Session& session) {
  for (const msg::StationEvent& event : session.events) {
    if (event.kind() != msg::EVENT_KIND_LINK) continue;
    const std::optional<std::string> way = wire::way_of_images(event.text());
    if (!way || (!summary.ways.empty() && summary.ways.back().words == *way)) continue;
    const auto since_ns = static_cast<std::int64_t>(event.stamp_ns()) - session.first_ns.value_or(0);
    summary.ways.push_back({.from_s = to_seconds(Nanoseconds(since_ns)), .words = *way});
  }
}

}  // namespace

std::vector<double> force_norm_N(const Ticks& ticks) {
  std::vector<double> norms;
  norms.reserve(ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i)
    norms.push_back(std::hypot(double{ticks.force[0][i]}, double{ticks.force[1][i]}, double{ticks.force[2][i]}));
  return norms;
}

Summary summarise(const Session& session) {
  Summary summary;
  summary.seconds = seconds(session);
  summary.dwells.resize(ar::kPhases.size());
  summary.damaged_messages = session.damaged;
  summary.camera_depth_per_s = mean_rate(session.depth_captured_ns);
  summary.camera_color_per_s = mean_rate(session.color_captured_ns);
  if (session.ticks.size() > 0) add_ticks(summary, session.ticks);
  std::vector<std::int64_t> state_times;
  for (const msg::StationState& state : session.states)
    state_times.push_back(static_cast<std::int64_t>(state.stamp_ns()));
  summary.states_per_s = mean_rate(state_times);
  add_latencies(summary, session);
  add_compensation(summary, session);
  add_energy(summary, session);
  add_stats(summary, session);
  add_senders(summary, session);
  add_ways(summary, session);
  if (!session.depth_captured_ns.empty()) summary.depth_images = session.depth_captured_ns.size();
  if (!session.surfaces.empty()) summary.surfaces = session.surfaces.size();
  summary.depth = depth_of(session);
  return summary;
}

}  // namespace telepalp::report
