#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/task/design.h"

namespace telepalp::study {

/// Values that a search may give to one parameter of mechanism_parameters(), in that parameter's unit of text: mm or
/// rad. `least` == `most`: the parameter is fixed at this value.
struct SearchRange {
  std::string name;
  double least = 0.0;
  double most = 0.0;
};

inline constexpr int kLeastEvaluations = 40;  ///< mechanisms that a search judges at least: S4's 36, and a few more

/// The mechanisms among which a search looks. A parameter that is not named has the value of S4's first linkage; l4 and
/// the needle's length, if not named, are drawn for each operator (plant_ranges()).
struct SearchBox {
  std::vector<SearchRange> ranges;  ///< each name at most once
};

/// The smallest box that holds the 36 mechanisms of S4's Table 1: l1, l2, l3, theta, phi, h and l_h.
[[nodiscard]] SearchBox paper_box();

/// Sets one range of `box` from the text MIN:MAX, or from one number, which fixes the parameter. `where` is for the
/// error. Error: an unknown name, a text that is no range, min > max, a number that is not finite or out of bounds.
[[nodiscard]] Result<void> set_range(SearchBox& box, std::string_view name, std::string_view text,
                                     const std::string& where);

/// Changes `box` by a text with one parameter a line, `l1=80:120`. Lines that begin with # are comments. Error:
/// `file:line:column`, with what is wrong and how to fix it.
[[nodiscard]] Result<SearchBox> parse_box(SearchBox box, const std::string& text, const std::string& file);

/// `box`, if it can be searched. Error: as of set_range(), a name given twice, or no range that is wider than 0.
[[nodiscard]] Result<SearchBox> checked(const SearchBox& box);

/// Ranges of `box` that are wider than 0: the dimensions of the search, in the order of the box.
[[nodiscard]] std::vector<SearchRange> free_ranges(const SearchBox& box);

/// The mechanism at `unit`: one share in [0, 1] of each of free_ranges(), from least to most.
[[nodiscard]] Configuration mechanism_at(const SearchBox& box, const std::vector<double>& unit);

/// The inverse of mechanism_at(). nullopt: a parameter of `mechanism` lies outside its range, or is not what the box
/// fixes.
[[nodiscard]] std::optional<std::vector<double>> place_in(const SearchBox& box, const Configuration& mechanism);

}  // namespace telepalp::study
