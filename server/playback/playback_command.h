#pragma once

#include <string>
#include <string_view>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::playback {

inline constexpr double kSlowest = 0.1;   ///< smallest speed, as a factor of the recorded pace
inline constexpr double kFastest = 10.0;  ///< largest speed, as a factor of the recorded pace

/// Parses a PlaybackCommand from JSON. Error: the text is not JSON, has an unknown field, or a value is out of its
/// range.
[[nodiscard]] Result<msg::PlaybackCommand> read_command(const std::string& json);

/// Error: a value is out of its range.
[[nodiscard]] Result<void> check(const msg::PlaybackCommand& command);

/// How a server shall play a session: the text after `session:`, FILE.mcap[,from_s=…][,speed=…][,paused=yes|no]
/// [,topics=A+B].
struct PlaybackSpec {
  std::string file;
  double from_s = 0.0;
  double speed = 1.0;
  bool paused = false;
  std::vector<std::string> topics{"/camera/*", "/station/*", "/patient/voice", "/doctor/voice"};
};
[[nodiscard]] Result<PlaybackSpec> read_spec(const std::string& text);

}  // namespace telepalp::playback
