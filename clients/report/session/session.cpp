#include "clients/report/session/session.h"

#include <algorithm>
#include <utility>

#include "proto/wire/camera/color_message.h"
#include "proto/wire/topics.h"

namespace telepalp::report {
namespace {

template <class Column, class Values>
void extend(Column& column, const Values& values) {
  column.insert(column.end(), values.begin(), values.end());
}

/// Adds a batch of ticks. A batch with columns of different lengths is damaged, because its ticks are ambiguous.
bool add_ticks(Ticks& ticks, const msg::StationTicks& batch) {
  const int size = batch.late_ns_size();
  const int lengths[] = {
      batch.work_us_size(), batch.phase_size(),    batch.hand_x_size(),        batch.hand_y_size(),
      batch.hand_z_size(),  batch.device_x_size(), batch.device_y_size(),      batch.device_z_size(),
      batch.proxy_x_size(), batch.proxy_y_size(),  batch.proxy_z_size(),       batch.force_x_size(),
      batch.force_y_size(), batch.force_z_size(),  batch.indentation_m_size(), batch.distance_m_size()};
  if (std::any_of(std::begin(lengths), std::end(lengths), [&](int length) { return length != size; })) return false;
  ticks.period_ns = batch.period_ns() > 0 ? batch.period_ns() : ticks.period_ns;
  if (size == 0) return true;
  if (ticks.at_ns.empty()) ticks.first_number = batch.first_tick();
  ticks.last_number = batch.first_tick() + static_cast<std::uint64_t>(size) - 1;
  for (int i = 0; i < size; ++i) {
    ticks.at_ns.push_back(static_cast<std::int64_t>(batch.first_tick_ns()) + std::int64_t{i} * ticks.period_ns);
    ticks.late_us.push_back(static_cast<float>(batch.late_ns(i)) * 1e-3F);
    ticks.phase.push_back(batch.phase(i));
  }
  extend(ticks.work_us, batch.work_us());
  extend(ticks.hand[0], batch.hand_x());
  extend(ticks.hand[1], batch.hand_y());
  extend(ticks.hand[2], batch.hand_z());
  extend(ticks.device[0], batch.device_x());
  extend(ticks.device[1], batch.device_y());
  extend(ticks.device[2], batch.device_z());
  extend(ticks.proxy[0], batch.proxy_x());
  extend(ticks.proxy[1], batch.proxy_y());
  extend(ticks.proxy[2], batch.proxy_z());
  extend(ticks.force[0], batch.force_x());
  extend(ticks.force[1], batch.force_y());
  extend(ticks.force[2], batch.force_z());
  extend(ticks.indentation_m, batch.indentation_m());
  extend(ticks.distance_m, batch.distance_m());
  return true;
}

/// The record of this sender; a new one at its first message.
SenderRecord& record_of(Session& session, std::uint32_t sender) {
  if (session.sent_messages == 0) session.sender = sender;
  if (session.sender == sender) return session;
  SenderRecord& other = session.others[sender];
  other.sender = sender;
  return other;
}

/// Parses the payload as `Proto` and passes it to `take`. False if it cannot be parsed or `take` rejects it.
template <class Proto, class Take>
bool read(const wire::Message& message, Take take) {
  Proto proto;
  return proto.ParseFromString(*message.payload) && take(proto);
}

/// A message of a station, kept in the list `list` of its sender.
template <class Proto>
bool keep_all(Session& session, const wire::Message& message, std::vector<Proto> SenderRecord::*list) {
  return read<Proto>(message, [&](Proto& proto) {
    SenderRecord& record = record_of(session, proto.sender());
    ++record.sent_messages;
    (record.*list).push_back(std::move(proto));
    return true;
  });
}

bool keep_ticks(Session& session, const wire::Message& message) {
  return read<msg::StationTicks>(message, [&](const auto& batch) {
    SenderRecord& record = record_of(session, batch.sender());
    ++record.sent_messages;
    return add_ticks(record.ticks, batch);
  });
}

/// True if the sender started during the recording: its ticks take less time than the recording so far.
bool started_here(const Session& session, std::uint64_t ticks, SessionTime published) {
  constexpr double kSlack_s = 0.5, kPeriod_s = 5e-4;
  const double recorded_s = to_seconds(Nanoseconds(to_nanoseconds(published) - session.first_ns.value_or(0)));
  return static_cast<double>(ticks) * kPeriod_s <= recorded_s + kSlack_s;
}

bool keep_stats(Session& session, const wire::Message& message) {
  return read<msg::StationStats>(message, [&](msg::StationStats& stats) {
    SenderRecord& record = record_of(session, stats.sender());
    if (!record.station_stats) record.began_here = started_here(session, stats.ticks(), message.published);
    ++record.sent_messages;
    record.frames_received.add(stats.frames_received(), record.began_here);
    record.deadlines_missed.add(stats.deadlines_missed(), record.began_here);
    record.telemetry_dropped.add(stats.telemetry_dropped(), record.began_here);
    record.frames_dropped.add(stats.frames_dropped(), record.began_here);
    record.counted_ns = to_nanoseconds(message.published);
    record.station_stats = std::move(stats);
    return true;
  });
}

void add_subscriber(Session& session, const msg::ServerStats::PerSubscriber& subscriber, std::int64_t at_ns) {
  const auto [place, is_new] =
      session.subscriptions.try_emplace({subscriber.name(), subscriber.address()}, Subscription{});
  Subscription& known = place->second;
  known.sender = subscriber.sender();
  known.name = subscriber.name();
  known.address = subscriber.address();
  if (is_new) known.was_there_first = !session.heard_server_stats;
  known.counted_ns = at_ns;
  if (subscriber.has_share_b_per_s()) known.shared_line.add(subscriber.share_b_per_s());
  if (known.carriers.empty() || known.carriers.back().by_datagram != subscriber.by_datagram())
    known.carriers.push_back({at_ns, subscriber.by_datagram()});
  for (const msg::ServerStats::PerTopic& topic : subscriber.topics()) {
    if (topic.topic() != wire::kCameraDepth.name) continue;
    if (is_new) known.depth_sent_before = topic.sent();
    if (is_new) known.depth_dropped_before = topic.dropped();
    known.depth_sent.add(topic.sent(), !known.was_there_first);
    known.depth_dropped.add(topic.dropped(), !known.was_there_first);
  }
}

bool keep_server_stats(Session& session, const wire::Message& message) {
  return read<msg::ServerStats>(message, [&](const msg::ServerStats& stats) {
    const std::int64_t at_ns = to_nanoseconds(message.published);
    for (const auto& subscriber : stats.subscribers()) add_subscriber(session, subscriber, at_ns);
    session.heard_server_stats = true;
    if (!stats.software().empty()) session.server_software = stats.software();
    return true;
  });
}

template <class Proto>
bool keep_last(const wire::Message& message, std::optional<Proto>& last) {
  return read<Proto>(message, [&](Proto& proto) {
    last = std::move(proto);
    return true;
  });
}

bool keep_color_time(Session& session, const wire::Message& message) {
  const std::optional<wire::CompressedColor> color = wire::compressed_color(message);
  if (!color) return false;
  session.color_captured_ns.push_back(color->captured_ns);
  return true;
}

bool add_readable(Session& session, const wire::Message& message) {
  const std::string_view topic = message.topic.name;
  if (topic == wire::kStationTicks.name) return keep_ticks(session, message);
  if (topic == wire::kStationState.name) return keep_all(session, message, &SenderRecord::states);
  if (topic == wire::kStationSurface.name) return keep_all(session, message, &SenderRecord::surfaces);
  if (topic == wire::kStationCompensation.name) return keep_all(session, message, &SenderRecord::compensations);
  if (topic == wire::kStationEvents.name) return keep_all(session, message, &SenderRecord::events);
  if (topic == wire::kStationStats.name) return keep_stats(session, message);
  if (topic == wire::kServerStats.name) return keep_server_stats(session, message);
  if (topic == wire::kCameraStatus.name) return keep_last(message, session.capture);
  if (topic == wire::kCameraInfo.name)
    return read<foxglove::CameraCalibration>(message, [&](const auto& calibration) {
      session.calibrations[calibration.frame_id()] = calibration;
      return true;
    });
  if (topic == wire::kCameraDepth.name)
    return read<msg::DepthImage>(message, [&](const auto& image) {
      const std::int64_t logged_ns = to_nanoseconds(message.published);
      session.depth = wire::less_exact(session.depth, wire::depth_fidelity(image));
      session.depth_captured_ns.push_back(static_cast<std::int64_t>(image.captured_ns()));
      session.depth_key_ns.push_back(message.key_frame || session.depth_key_ns.empty() ? logged_ns
                                                                                       : session.depth_key_ns.back());
      return true;
    });
  if (wire::carries_color(message.topic)) return keep_color_time(session, message);
  return true;
}

}  // namespace

void add(Session& session, const wire::Message& message) {
  const std::int64_t at = to_nanoseconds(message.published);
  session.first_ns = std::min(session.first_ns.value_or(at), at);
  session.last_ns = std::max(session.last_ns.value_or(at), at);
  ++session.messages;
  if (!add_readable(session, message)) ++session.damaged;
}

void Growth::add(std::uint64_t value, bool began_here) noexcept {
  known_ = last_ || began_here;
  if (!last_) grown_ = began_here ? value : 0;
  if (last_) grown_ += value >= *last_ ? value - *last_ : value;
  last_ = value;
}

void settle(Session& session) {
  const auto weight = [](const SenderRecord& record) { return std::pair(record.ticks.size(), record.states.size()); };
  SenderRecord* most = &session;
  for (auto& [sender, other] : session.others)
    if (weight(other) > weight(*most)) most = &other;
  if (most == &session) return;
  SenderRecord chosen = std::move(*most);
  session.others.erase(chosen.sender);
  SenderRecord& own = session;
  SenderRecord before = std::exchange(own, std::move(chosen));
  session.others.insert_or_assign(before.sender, std::move(before));
}

std::string source_of(const Session& session) {
  return session.capture && !session.capture->source().empty() ? session.capture->source() : session.origin;
}

double seconds(const Session& session) noexcept {
  return session.first_ns ? to_seconds(Nanoseconds(*session.last_ns - *session.first_ns)) : 0.0;
}

}  // namespace telepalp::report
