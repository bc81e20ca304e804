#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "where.h"

namespace {

namespace fs = std::filesystem;

/// Files below `folder` may include files below `may_include` and nothing else of telepalp's. CMake's targets enforce
/// the same at link time; includes of header-only pieces would slip through, so they are read here.
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

const std::vector<std::string> kTopFolders{"proto", "codec", "server", "haptic_station", "clients", "tests"};

fs::path root() { return TELEPALP_SOURCE_DIR; }

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

std::vector<fs::path> sources(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root() / folder))
    if (entry.is_regular_file() && is_source(entry.path())) files.push_back(entry.path());
  return files;
}

std::vector<std::string> includes(const fs::path& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"][^>"]+[>"]))re");
  std::vector<std::string> found;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) found.push_back(match[1]);
  }
  return found;
}

bool is_below(const std::string& path, const std::string& folder) { return path.starts_with(folder + "/"); }

bool is_ours(const std::string& include) {
  return std::any_of(kTopFolders.begin(), kTopFolders.end(), [&](const auto& top) { return is_below(include, top); });
}

/// The most specific rule for a file.
const Rule* rule_for(const std::string& file) {
  const Rule* best = nullptr;
  for (const Rule& rule : kRules)
    if (is_below(file, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size())) best = &rule;
  return best;
}

TEST(Architecture, EveryFileIncludesOnlyWhatItsFolderMayKnow) {
  for (const std::string top : {"proto", "codec", "server", "haptic_station", "clients"}) {
    for (const fs::path& file : sources(top)) {
      const std::string name = fs::relative(file, root()).string();
      const Rule* rule = rule_for(name);
      ASSERT_NE(rule, nullptr) << name;
      for (const std::string& quoted : includes(file)) {
        const std::string include = quoted.substr(1, quoted.size() - 2);
        if (!is_ours(include)) continue;
        EXPECT_TRUE(std::any_of(rule->may_include.begin(), rule->may_include.end(),
                                [&](const auto& allowed) { return is_below(include, allowed); }))
            << name << " may not include " << include;
      }
    }
  }
}

TEST(Architecture, NothingOfTheRealTimePartCanWaitOrSerialise) {
  for (const std::string& folder : kRealTimeFolders)
    for (const fs::path& file : sources(folder))
      for (const std::string& include : includes(file))
        for (const std::string& banned : kNotInRealTime)
          EXPECT_EQ(include.find(banned), std::string::npos) << file << " includes " << include;
}

TEST(Architecture, AClientIsThin) {
  for (const fs::path& file : sources("clients"))
    for (const std::string& include : includes(file)) {
      EXPECT_EQ(include.find("pcl/"), std::string::npos) << file;
      EXPECT_EQ(include.find("OpenNI"), std::string::npos) << file;
    }
}

}  // namespace
