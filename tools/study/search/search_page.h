#pragma once

#include <string>

#include "tools/study/search/design_search.h"

namespace telepalp::study {

/// A table for a terminal: the front, each mechanism judged by the search's operators and by held-out ones.
[[nodiscard]] std::string search_text(const SearchSettings& settings, const SearchResult& result);
[[nodiscard]] std::string search_json(const SearchBox& box, const SearchSettings& settings, const SearchResult& result);
/// The page, with plots; self-contained, without scripts.
[[nodiscard]] std::string search_html(const SearchBox& box, const SearchSettings& settings, const SearchResult& result);

}  // namespace telepalp::study
