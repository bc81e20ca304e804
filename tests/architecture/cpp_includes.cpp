#include "tests/architecture/cpp_includes.h"

#include <algorithm>
#include <fstream>
#include <regex>

#include "where.h"

namespace telepalp::architecture {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSourceFolders{"proto",          "support", "codec", "server",
                                              "haptic_station", "clients", "tools"};

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

}  // namespace

fs::path root() { return TELEPALP_SOURCE_DIR; }

std::vector<std::string> sources(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root() / folder))
    if (entry.is_regular_file() && is_source(entry.path())) files.push_back(fs::relative(entry, root()).string());
  return files;
}

std::vector<std::string> all_sources() {
  std::vector<std::string> all;
  for (const std::string& folder : kSourceFolders)
    for (std::string& file : sources(folder)) all.push_back(std::move(file));
  return all;
}

std::vector<std::string> includes(const std::string& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(?:"([^"]+)"|(<[^>]+>)))re");
  std::vector<std::string> found;
  std::ifstream stream(root() / file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) found.push_back(match[1].matched ? match[1] : match[2]);
  }
  return found;
}

Includes all_includes() {
  Includes all;
  for (const std::string& file : all_sources()) all[file] = includes(file);
  return all;
}

bool is_below(const std::string& path, const std::string& folder) {
  return path.size() > folder.size() && path[folder.size()] == '/' && path.starts_with(folder);
}

bool is_ours(const std::string& include) {
  return std::any_of(kSourceFolders.begin(), kSourceFolders.end(),
                     [&](const auto& top) { return is_below(include, top); });
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

std::set<std::string> namespaces(const std::string& file) {
  static const std::regex kNamespace(R"re(^namespace (telepalp[a-z_:]*) \{)re");
  std::set<std::string> found;
  std::ifstream stream(root() / file);
  for (std::string line; std::getline(stream, line);)
    if (std::smatch match; std::regex_search(line, match, kNamespace)) found.insert(match[1]);
  return found;
}

Rooms read_rooms() {
  Rooms rooms;
  std::ifstream stream(TELEPALP_BINARY_DIR "/where/doors.txt");
  for (std::string folder, door; stream >> folder >> door;) {
    if (folder == "room")
      rooms.doors[door];
    else if (folder == "why")
      rooms.with_a_reason.insert(door);
    else
      rooms.doors[folder].insert(door);
  }
  return rooms;
}

}  // namespace telepalp::architecture
