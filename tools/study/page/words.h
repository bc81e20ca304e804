#pragma once

#include <string>
#include <vector>

#include "tools/study/page/results.h"

namespace telepalp::study {

/// "8.2 (6.9 to 9.8)"
[[nodiscard]] std::string in_words(const Interval& interval);
/// "-60 %"
[[nodiscard]] std::string change(double to, double from);
/// What the study found, sentence by sentence.
[[nodiscard]] std::vector<std::string> findings(const StudySettings& settings, const StudyResult& result);

}  // namespace telepalp::study
