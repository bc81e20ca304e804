#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "where.h"

namespace {

namespace fs = std::filesystem;

/// Files below `folder` may include files below `may_include` and no other file of telepalp. CMake's targets enforce
/// the same at link time; this test also sees headers that need no linking.
struct Rule {
  std::string folder;
  std::vector<std::string> may_include;
};

const std::vector<Rule> kRules{
    {"proto/words", {"proto/words"}},
    {"proto/wire", {"proto/words", "proto/wire", "messages", "foxglove"}},
    {"proto/program", {"proto/words", "proto/program"}},
    {"proto/models", {"proto/words", "proto/models"}},
    {"codec", {"proto/words", "codec"}},
    {"server", {"proto", "codec", "server", "messages", "foxglove"}},
    {"haptic_station/surface", {"proto/words", "proto/models", "haptic_station/surface"}},
    {"haptic_station/ports", {"proto/words", "haptic_station/ports"}},
    {"haptic_station/effects", {"proto/words", "haptic_station/ports", "haptic_station/effects"}},
    {"haptic_station/control",
     {"proto/words", "haptic_station/ports", "haptic_station/effects", "haptic_station/control"}},
    {"haptic_station/device", {"proto", "messages", "haptic_station/ports", "haptic_station/device"}},
    {"haptic_station/tracking",
     {"proto", "messages", "haptic_station/ports", "haptic_station/device", "haptic_station/tracking"}},
    {"haptic_station/loop", {"proto/words", "haptic_station"}},
    {"haptic_station", {"proto", "codec", "haptic_station", "messages", "foxglove"}},
    {"clients", {"proto", "codec", "clients", "messages", "foxglove"}},
};

/// What the real-time part must never see: what waits, and what is not in its libraries.
const std::vector<std::string> kNotInRealTime{"<mutex>",  "<condition_variable>", "<thread>",
                                              "<future>", "boost/asio",           ".pb.h",
                                              "pcl/",     "<iostream>",           "<fstream>"};
const std::vector<std::string> kRealTimeFolders{"haptic_station/control", "haptic_station/loop"};

const std::vector<std::string> kSourceFolders{"proto", "codec", "server", "haptic_station", "clients"};
constexpr std::size_t kMostDoors = 4;

fs::path root() { return TELEPALP_SOURCE_DIR; }

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

/// Relative to the repository.
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

/// As written between quotes or angle brackets, the latter kept: <mutex>.
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

bool is_below(const std::string& path, const std::string& folder) { return path.starts_with(folder + "/"); }

bool is_ours(const std::string& include) {
  return std::any_of(kSourceFolders.begin(), kSourceFolders.end(),
                     [&](const auto& top) { return is_below(include, top); });
}

/// Folder to its doors, as the CMakeLists.txt files name them.
std::map<std::string, std::set<std::string>> doors() {
  std::map<std::string, std::set<std::string>> found;
  std::ifstream stream(TELEPALP_BINARY_DIR "/where/doors.txt");
  for (std::string folder, door; stream >> folder >> door;) found[folder].insert(door);
  return found;
}

/// The most specific rule for a file.
const Rule* rule_for(const std::string& file) {
  const Rule* best = nullptr;
  for (const Rule& rule : kRules)
    if (is_below(file, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size())) best = &rule;
  return best;
}

TEST(Architecture, EveryFileIncludesOnlyWhatItsFolderMayKnow) {
  for (const std::string& file : all_sources()) {
    const Rule* rule = rule_for(file);
    ASSERT_NE(rule, nullptr) << file;
    for (const std::string& include : includes(file)) {
      if (!is_ours(include)) continue;
      EXPECT_TRUE(std::any_of(rule->may_include.begin(), rule->may_include.end(),
                              [&](const auto& allowed) { return is_below(include, allowed); }))
          << file << " may not include " << include;
    }
  }
}

/// A file outside a room enters it by a door of that room, and by one of each room around it.
TEST(Architecture, EveryRoomIsEnteredByItsDoors) {
  const auto rooms = doors();
  ASSERT_FALSE(rooms.empty());
  for (const std::string& file : all_sources())
    for (const std::string& include : includes(file))
      for (const auto& [room, its_doors] : rooms) {
        const bool enters = is_below(include, room) && !is_below(file, room);
        EXPECT_TRUE(!enters || its_doors.contains(include))
            << file << " passes by the doors of " << room << ": " << include;
      }
}

TEST(Architecture, EveryRoomHasAFewDoors) {
  for (const auto& [room, its_doors] : doors()) {
    std::cout << room << ":";
    for (const std::string& door : its_doors) std::cout << " " << door.substr(room.size() + 1);
    std::cout << "\n";
    EXPECT_LE(its_doors.size(), kMostDoors) << room;
  }
}

TEST(Architecture, NothingOfTheRealTimePartCanWaitOrSerialise) {
  for (const std::string& folder : kRealTimeFolders)
    for (const std::string& file : sources(folder))
      for (const std::string& include : includes(file))
        for (const std::string& banned : kNotInRealTime)
          EXPECT_EQ(include.find(banned), std::string::npos) << file << " includes " << include;
}

TEST(Architecture, AClientIsThin) {
  for (const std::string& file : sources("clients"))
    for (const std::string& include : includes(file)) {
      EXPECT_EQ(include.find("pcl/"), std::string::npos) << file;
      EXPECT_EQ(include.find("OpenNI"), std::string::npos) << file;
    }
}

}  // namespace
