#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "proto/words/result.h"

namespace telepalp::playback {

/// Reads JSON into `message`. Error: it is not JSON, or has an unknown field. `fix` says what to send instead.
[[nodiscard]] Result<void> read_json(const std::string& json, google::protobuf::Message& message, std::string fix);

}  // namespace telepalp::playback
