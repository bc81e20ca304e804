#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace telepalp::program {

/// A message as one line of Protobuf's JSON: names as in the .proto file, and values that equal their default as well,
/// because readers in browsers expect every member. "{}" if a text in the message is not UTF-8, such as a file's name.
[[nodiscard]] std::string to_json(const google::protobuf::Message& message);

}  // namespace telepalp::program
