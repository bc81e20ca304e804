#pragma once

#include <string>
#include <vector>

#include "tools/study/search/design_search.h"

namespace telepalp::study {

/// What the search found, sentence by sentence.
[[nodiscard]] std::vector<std::string> search_findings(const SearchSettings& settings, const SearchResult& result);

/// "4.92 (3.80 to 6.10)"
[[nodiscard]] std::string in_words_2(const Interval& interval);

/// The parameters of mechanism_parameters() in mm and rad: "105", "-0.12", "drawn".
[[nodiscard]] std::vector<std::string> parameter_texts(const Configuration& mechanism);

/// The mechanisms of the result that are shown in tables: the front, then the best of S4's 36 here and in S4's Table 2.
struct ShownDesign {
  std::string from;  ///< "front 1", "best of S4's 36 here", "best in S4's Table 2"
  const SearchedDesign* design;
};
[[nodiscard]] std::vector<ShownDesign> shown_designs(const SearchResult& result);

}  // namespace telepalp::study
