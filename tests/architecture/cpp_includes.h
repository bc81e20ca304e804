#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace telepalp::architecture {

/// File to its includes. Names in angle brackets keep the brackets: <mutex>.
using Includes = std::map<std::string, std::vector<std::string>>;

[[nodiscard]] std::filesystem::path root();

/// Paths of C++ files below `folder`, relative to the repository.
[[nodiscard]] std::vector<std::string> sources(const std::string& folder);

/// Those of all folders that hold the product.
[[nodiscard]] std::vector<std::string> all_sources();

[[nodiscard]] std::vector<std::string> includes(const std::string& file);
[[nodiscard]] Includes all_includes();

[[nodiscard]] bool is_below(const std::string& path, const std::string& folder);
[[nodiscard]] bool is_ours(const std::string& include);
[[nodiscard]] std::string folder_of(const std::string& file);

/// The namespaces of telepalp that a file opens.
[[nodiscard]] std::set<std::string> namespaces(const std::string& file);

/// The rooms of the house, as the CMakeLists.txt files name them.
struct Rooms {
  std::map<std::string, std::set<std::string>> doors;  ///< folder to its doors
  std::set<std::string> with_a_reason;                 ///< rooms that state a reason for many doors
};

[[nodiscard]] Rooms read_rooms();

}  // namespace telepalp::architecture
