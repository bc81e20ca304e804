#include "tools/replay/source/session_hand.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {
namespace {

constexpr double kFarthest_m = 10.0;  // a place beyond this is no hand's

bool is_place(const Eigen::Vector3d& at) { return at.allFinite() && at.norm() < kFarthest_m; }

/// True if all columns of the batch have one length, as telepalp writes them. Other batches are skipped.
bool has_all_columns(const msg::StationTicks& ticks) {
  const int size = ticks.device_x_size();
  return ticks.device_y_size() == size && ticks.device_z_size() == size && ticks.hand_x_size() == size &&
         ticks.hand_y_size() == size && ticks.hand_z_size() == size;
}

void append(const msg::StationTicks& ticks, Nanoseconds shift, RecordedHand& hand) {
  if (!has_all_columns(ticks)) return;
  for (int i = 0; i < ticks.device_x_size(); ++i) {
    const SessionTime at =
        session_time(static_cast<std::int64_t>(ticks.first_tick_ns()) + std::int64_t{ticks.period_ns()} * i) + shift;
    const Eigen::Vector3d device(ticks.device_x(i), ticks.device_y(i), ticks.device_z(i));
    const Eigen::Vector3d palm(ticks.hand_x(i), ticks.hand_y(i), ticks.hand_z(i));
    if (!is_place(device) || !is_place(palm) || (!hand.empty() && at <= hand.back().at)) continue;
    hand.push_back({at, {device}, {palm}});
  }
}

/// Capture time of the first depth frame that has a camera model, as the source counts frames.
Result<std::optional<SessionTime>> first_frame(wire::McapReader& reader) {
  reader.select({.topics = {std::string(wire::kCameraInfo.name), std::string(wire::kCameraDepth.name)}});
  bool has_camera = false;
  for (;;) {
    const Result<std::optional<wire::Message>> message = reader.next();
    if (!message) return message.error();
    if (!*message) return std::optional<SessionTime>{};
    has_camera |= (*message)->topic.name == wire::kCameraInfo.name;
    msg::DepthImage depth;
    if (has_camera && (*message)->topic.name == wire::kCameraDepth.name && depth.ParseFromString(*(*message)->payload))
      return std::optional(session_time(static_cast<std::int64_t>(depth.captured_ns())));
  }
}

}  // namespace

Result<RecordedHand> read_session_hand(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<std::optional<SessionTime>> first = first_frame(*reader);
  if (!first) return first.error();
  if (!*first) return RecordedHand{};
  std::map<std::uint32_t, RecordedHand> hands;  // by sender
  reader->select({.topics = {std::string(wire::kStationTicks.name)}});
  for (;;) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    msg::StationTicks ticks;
    if (!ticks.ParseFromString(*(*message)->payload))
      return Error{.what = "holds a damaged message on /station/ticks, so the recorded hand is not known",
                   .where = file.string(),
                   .fix = "give --hand SCRIPT instead of the recorded hand; telepalp-record verify " + file.string() +
                          " names the damage"};
    append(ticks, kBegin - **first, hands[ticks.sender()]);
  }
  const auto most = std::max_element(hands.begin(), hands.end(),
                                     [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  return most == hands.end() ? RecordedHand{} : std::move(most->second);
}

}  // namespace telepalp::replay
