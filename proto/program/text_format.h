#pragma once

#include <google/protobuf/message.h>

#include <filesystem>

#include "proto/words/result.h"

namespace telepalp::program {

/// Reads a Protobuf text-format file (a scene, a camera) into `message`. An unknown field, a wrong type or a
/// missing brace is an error with the file, line and column. Files over 1 MiB are refused.
[[nodiscard]] Result<void> read_text_format(const std::filesystem::path& file, google::protobuf::Message& message);

/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<void> parse_text_format(const std::string& text, const std::string& name,
                                             google::protobuf::Message& message);

}  // namespace telepalp::program
