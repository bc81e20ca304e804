#include "server/gateway/foxglove/playback_control.h"

#include <cmath>

#include "proto/words/little_endian.h"

namespace telepalp::gateway::foxglove {
namespace {

constexpr char kRequestOpcode = 0x03;
constexpr char kStateOpcode = 0x05;
constexpr std::size_t kRequestHeadBytes = 19;
constexpr std::size_t kMaxIdBytes = 256;
enum class Status : std::uint8_t { Playing = 0, Paused = 1, Ended = 3 };

std::uint64_t ns_at(const msg::PlaybackState& state, double position_s) {
  return state.begin_ns() + static_cast<std::uint64_t>(std::llround(1e9 * position_s));
}

Status status_of(const msg::PlaybackState& state) {
  if (state.playing()) return Status::Playing;
  return state.position_s() >= state.duration_s() && state.duration_s() > 0.0 ? Status::Ended : Status::Paused;
}

std::string message(Status status, std::uint64_t time_ns, double speed, bool did_seek, const std::string& id) {
  std::string out(1, kStateOpcode);
  append_little_endian<std::uint8_t>(out, static_cast<std::uint8_t>(status));
  append_little_endian<std::uint64_t>(out, time_ns);
  append_little_endian<float>(out, static_cast<float>(speed));
  append_little_endian<std::uint8_t>(out, did_seek ? 1 : 0);
  append_little_endian<std::uint32_t>(out, static_cast<std::uint32_t>(id.size()));
  return out + id;
}

Error control_refused(std::string what) {
  return {.what = std::move(what),
          .where = "playback request",
          .fix =
              "send a command, a speed from 0.1 to 10 and a time between dataStartTime and dataEndTime of the server's "
              "serverInfo message"};
}

}  // namespace

bool is_playback_request(std::string_view bytes) noexcept { return !bytes.empty() && bytes.front() == kRequestOpcode; }

Result<PlaybackRequest> read_playback_request(std::string_view bytes, const msg::PlaybackState& state) {
  if (bytes.size() < kRequestHeadBytes) return control_refused("is truncated");
  const std::size_t id_bytes = get_little_endian<std::uint32_t>(bytes.data() + 15);
  if (id_bytes > kMaxIdBytes || id_bytes != bytes.size() - kRequestHeadBytes)
    return control_refused("has a wrong length");
  if (bytes[1] != 0 && bytes[1] != 1) return control_refused("has an unknown command");
  PlaybackRequest request{.play = bytes[1] == 0,
                          .speed = double{get_little_endian<float>(bytes.data() + 2)},
                          .seek_ns = {},
                          .id = std::string(bytes.substr(kRequestHeadBytes))};
  if (!std::isfinite(request.speed)) return control_refused("has a speed that is not a number");
  if (bytes[6] == 0) return request;
  request.seek_ns = get_little_endian<std::uint64_t>(bytes.data() + 7);
  if (*request.seek_ns < state.begin_ns() || *request.seek_ns > end_ns(state))
    return control_refused("seeks to a time outside of the session");
  return request;
}

msg::PlaybackCommand command_of(const PlaybackRequest& request, const msg::PlaybackState& state) {
  msg::PlaybackCommand command;
  command.set_play(request.play);
  command.set_speed(request.speed);
  if (request.seek_ns) command.set_seek_s(1e-9 * static_cast<double>(*request.seek_ns - state.begin_ns()));
  return command;
}

std::string playback_state(const msg::PlaybackState& state) {
  return message(status_of(state), ns_at(state, state.position_s()), state.speed(), false, {});
}

std::string playback_reply(const msg::PlaybackState& state, const PlaybackRequest& request) {
  return message(request.play ? Status::Playing : Status::Paused,
                 request.seek_ns.value_or(ns_at(state, state.position_s())), request.speed, request.seek_ns.has_value(),
                 request.id);
}

std::uint64_t end_ns(const msg::PlaybackState& state) noexcept { return ns_at(state, state.duration_s()); }

}  // namespace telepalp::gateway::foxglove
