#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::bench {

/// True if `name` contains one of `parts`, which commas separate, or if `parts` is empty.
[[nodiscard]] inline bool contains_one_of(std::string_view name, std::string_view parts) {
  if (parts.empty()) return true;
  while (!parts.empty()) {
    const std::size_t comma = parts.find(',');
    if (name.find(parts.substr(0, comma)) != std::string_view::npos) return true;
    parts.remove_prefix(comma == std::string_view::npos ? parts.size() : comma + 1);
  }
  return false;
}

/// The section of `all` that --part names; without --part, all. Error: no section has this name.
template <class Section>
[[nodiscard]] Result<std::vector<Section>> chosen_sections(const std::vector<Section>& all,
                                                           const program::Arguments& arguments,
                                                           const std::string& bench) {
  if (!arguments.has("part")) return all;
  std::string names;
  for (const Section& section : all) {
    if (section.name == arguments.text("part")) return std::vector<Section>{section};
    names += (names.empty() ? "" : ", ") + std::string(section.name);
  }
  return Error{.what = "'" + arguments.text("part") + "' is not a part of telepalp-bench " + bench,
               .where = "--part",
               .fix = "give one of " + names};
}

}  // namespace telepalp::bench
