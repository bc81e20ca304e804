#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::wire {

/// The first difference of two sessions in words, with the fields that differ; nullopt: their messages are equal.
/// Metadata, such as the program's version, is not compared. Error: a file cannot be read.
[[nodiscard]] Result<std::optional<std::string>> first_difference(const std::filesystem::path& a,
                                                                  const std::filesystem::path& b);

}  // namespace telepalp::wire
