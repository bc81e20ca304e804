#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "proto/words/result.h"

namespace telepalp::program {

/// A message as one line of Protobuf's JSON: names as in the .proto file, and values that equal their default as well,
/// because readers in browsers expect every member. "{}" if a text in the message is not UTF-8, such as a file's name.
[[nodiscard]] std::string to_json(const google::protobuf::Message& message);

/// Reads Protobuf's JSON into `message`. Error: invalid JSON, an unknown field, or a value of the wrong type; the
/// Error contains `where` and `fix`.
[[nodiscard]] Result<void> read_json(const std::string& json, google::protobuf::Message& message, std::string where,
                                     std::string fix);

}  // namespace telepalp::program
