#pragma once

#include <string>

#include "tools/study/page/results.h"

namespace telepalp::study {

/// A table for a terminal: mechanisms, overshoots of each condition, and S4's Table 2 beside them.
[[nodiscard]] std::string result_text(const StudySettings& settings, const StudyResult& result);
[[nodiscard]] std::string result_json(const StudySettings& settings, const StudyResult& result);
/// The page, with plots; self-contained, without scripts.
[[nodiscard]] std::string result_html(const StudySettings& settings, const StudyResult& result);
/// All trials as CSV.
[[nodiscard]] std::string trials_csv(const StudySettings& settings, const std::vector<Trial>& trials);

}  // namespace telepalp::study
