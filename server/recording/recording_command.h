#pragma once

#include <string>

#include "messages/recording.pb.h"
#include "proto/words/result.h"

namespace telepalp::recording {

/// Parses a RecordingCommand from JSON. Error: the text is not JSON, has an unknown field or lacks the field `record`;
/// `record` is true and the consent is blank; or the consent is not one line of at most 200 bytes.
[[nodiscard]] Result<msg::RecordingCommand> read_command(const std::string& json);

}  // namespace telepalp::recording
