#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/cpp_includes.h"

namespace telepalp::architecture {

// The laws of the house. Each function returns the violations of one law, as sentences.

using Sentences = std::vector<std::string>;

/// Files below `folder` may include files below `may_include` and no other file of telepalp. CMake's targets enforce
/// the same at link time; this law also sees headers that need no linking.
struct Rule {
  std::string folder;
  std::vector<std::string> may_include;
};

/// Includes that the most specific rule for their file does not allow, and files without a rule.
[[nodiscard]] Sentences forbidden_includes(const Includes& all, const std::vector<Rule>& rules);

/// Includes that enter a room by a header that is no door of it. A file outside a room enters it by a door of that
/// room, and by one of each room around it.
[[nodiscard]] Sentences includes_past_the_doors(const Includes& all, const Rooms& rooms);

/// Rooms with more than a few doors, and without a reason.
[[nodiscard]] Sentences rooms_with_many_doors(const Rooms& rooms);

/// Files in no room that are not the main of a program.
[[nodiscard]] Sentences files_outside_rooms(const Includes& all, const Rooms& rooms);

/// Folders with too many files.
[[nodiscard]] Sentences crowded_folders(const Includes& all);

/// File to the namespaces that it opens.
using Namespaces = std::map<std::string, std::set<std::string>>;

/// Namespaces that are not those of the rooms around their file.
[[nodiscard]] Sentences foreign_namespaces(const Namespaces& all, const Rooms& rooms);

/// Circles of folders that include each other.
[[nodiscard]] Sentences circles_of_folders(const Includes& all);

/// Includes below `folders` whose name contains one of `banned`.
[[nodiscard]] Sentences banned_includes(const Includes& all, const std::vector<std::string>& folders,
                                        const std::vector<std::string>& banned);

}  // namespace telepalp::architecture
