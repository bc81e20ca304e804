#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/study/run/study.h"

namespace telepalp::study {

/// The trials of one operator in one condition as CSV, under a line that names the study. read_block() gives back
/// exactly the same numbers.
[[nodiscard]] std::string block_text(const std::string& identity, const std::vector<Trial>& trials);
/// nullopt: the text is cut off, or is of another study.
[[nodiscard]] std::optional<std::vector<Trial>> read_block(const std::string& identity, const std::string& text);

/// All on which a study's numbers depend, in one line: program, seed, counts, and a checksum of mechanisms and ranges.
[[nodiscard]] std::string identity_of(const StudySettings& settings);

}  // namespace telepalp::study
