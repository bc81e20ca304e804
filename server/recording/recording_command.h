#pragma once

#include <string>

#include "messages/recording.pb.h"
#include "proto/words/result.h"

namespace telepalp::recording {

/// Parses a RecordingCommand from JSON. Error: the text is not JSON or has an unknown field, it says neither begin nor
/// end, or it begins without a consent of 1 to 200 bytes in one line.
[[nodiscard]] Result<msg::RecordingCommand> read_command(const std::string& json);

}  // namespace telepalp::recording
