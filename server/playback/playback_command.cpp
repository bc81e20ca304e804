#include "server/playback/playback_command.h"

#include <boost/algorithm/string.hpp>
#include <cmath>
#include <optional>

#include "proto/words/number_word.h"
#include "support/program/message_json.h"

namespace telepalp::playback {
namespace {

constexpr double kLongest_s = 1e7;
constexpr std::uint32_t kMostSteps = 100;

constexpr const char* kPlaybackExample = "send JSON such as {\"seek_s\": 12.5, \"speed\": 0.5, \"play\": true}";

Error wrong(std::string what) { return {.what = std::move(what), .where = "playback", .fix = kPlaybackExample}; }

bool is_speed(double speed) { return speed >= kSlowest && speed <= kFastest; }
bool is_position(double seconds) { return seconds >= 0.0 && seconds <= kLongest_s; }

bool set(PlaybackSpec& spec, std::string_view key, std::string_view value) {
  const std::optional<double> given = number_of(value);
  if (key == "from_s" && given && is_position(*given)) {
    spec.from_s = *given;
  } else if (key == "speed" && given && is_speed(*given)) {
    spec.speed = *given;
  } else if (key == "paused" && (value == "yes" || value == "no")) {
    spec.paused = value == "yes";
  } else if (key == "topics" && !value.empty()) {
    boost::split(spec.topics, value, boost::is_any_of("+"), boost::token_compress_on);
  } else {
    return false;
  }
  return true;
}

}  // namespace

Result<msg::PlaybackCommand> read_command(const std::string& json) {
  msg::PlaybackCommand command;
  if (const Result<void> read = program::read_json(json, command, "playback", kPlaybackExample); !read)
    return read.error();
  if (const Result<void> valid = check(command); !valid) return valid.error();
  return command;
}

Result<void> check(const msg::PlaybackCommand& command) {
  if (command.has_seek_s() && !is_position(command.seek_s())) return wrong("seek_s is not from 0 to 10000000");
  if (command.has_speed() && !is_speed(command.speed())) return wrong("speed is not from 0.1 to 10");
  if (command.has_step() && (command.step() < 1 || command.step() > kMostSteps))
    return wrong("step is not from 1 to 100 depth images");
  if (command.has_step_back() && (command.step_back() < 1 || command.step_back() > kMostSteps))
    return wrong("step_back is not from 1 to 100 depth images");
  return {};
}

Result<PlaybackSpec> read_spec(const std::string& text) {
  constexpr std::string_view kEnd = ".mcap,";
  const std::size_t end = text.find(kEnd);
  PlaybackSpec spec;
  spec.file = end == std::string::npos ? text : text.substr(0, end + kEnd.size() - 1);
  if (end == std::string::npos) return spec;
  std::vector<std::string> pairs;
  const std::string rest = text.substr(end + kEnd.size());
  boost::split(pairs, rest, boost::is_any_of(","));
  for (const std::string& pair : pairs) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos || !set(spec, pair.substr(0, equals), pair.substr(equals + 1)))
      return Error{.what = "'" + pair + "' is not an option of a played session, or its value is not allowed",
                   .where = "--source session:" + text,
                   .fix = "give from_s=0 to 10000000, speed=0.1 to 10, paused=yes or no, topics=/camera/*+/station/*"};
  }
  return spec;
}

}  // namespace telepalp::playback
