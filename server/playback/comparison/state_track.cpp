#include "server/playback/comparison/state_track.h"

#include <cmath>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"

namespace telepalp::playback {
namespace {

float finite(double value) noexcept { return std::isfinite(value) ? static_cast<float>(value) : 0.0F; }

TrackPoint point_of(const msg::StationState& state) {
  return {.at_ns = static_cast<std::int64_t>(state.stamp_ns()),
          .force_N = {finite(state.force_n().x()), finite(state.force_n().y()), finite(state.force_n().z())},
          .indentation_m = finite(state.indentation_m()),
          .phase = state.phase()};
}

}  // namespace

Result<StateTrack> read_track(const std::filesystem::path& file, const std::atomic<bool>& stopping) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  StateTrack track{.begin_ns = static_cast<std::int64_t>(reader->summary().statistics.message_start_time),
                   .end_ns = static_cast<std::int64_t>(reader->summary().statistics.message_end_time),
                   .points = {},
                   .damaged = 0,
                   .is_cut = false};
  reader->select({.topics = {std::string(wire::kStationState.name)}});
  std::uint32_t station = 0;
  while (!stopping && !track.is_cut) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (message && !*message) break;
    msg::StationState state;
    if (!message || !state.ParseFromString(*(*message)->payload)) {
      ++track.damaged;
      continue;
    }
    if (track.points.empty()) station = state.sender();
    const TrackPoint point = point_of(state);
    const bool is_later = track.points.empty() || point.at_ns > track.points.back().at_ns;
    if (state.sender() != station || !is_later) continue;
    track.is_cut = track.points.size() == kMostTrackPoints;
    if (!track.is_cut) track.points.push_back(point);
  }
  if (track.points.empty())
    return Error{.what = "holds no state of a station",
                 .where = file.filename().string(),
                 .fix = "choose a session that was recorded while a station was connected"};
  return track;
}

}  // namespace telepalp::playback
