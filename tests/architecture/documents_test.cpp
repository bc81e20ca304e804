#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "where.h"

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kFoldersWithDocuments{"proto", "support",        "codec", "server", "clients",
                                                     "tools", "haptic_station", "docs",  "tests",  "deploy"};

fs::path root() { return TELEPALP_SOURCE_DIR; }

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_document(const fs::path& file) {
  return file.extension() == ".md" && file.string().find("node_modules") == std::string::npos;
}

std::vector<fs::path> documents() {
  std::vector<fs::path> found{root() / "README.md", root() / "CONTRIBUTING.md"};
  for (const std::string& folder : kFoldersWithDocuments)
    for (const auto& entry : fs::recursive_directory_iterator(root() / folder))
      if (entry.is_regular_file() && is_document(entry.path())) found.push_back(entry.path());
  return found;
}

/// The texts that the first group of `pattern` matches in `text`.
std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

bool starts_in_a_folder_of_ours(const std::string& path) {
  return std::any_of(kFoldersWithDocuments.begin(), kFoldersWithDocuments.end(),
                     [&](const std::string& folder) { return path.starts_with(folder + "/"); });
}

TEST(Documents, NameOnlyFilesThatExist) {
  const std::regex link(R"(\]\(([^)#:]+)(?:#[^)]*)?\))");
  const std::regex path(R"(`([A-Za-z0-9_./-]+)`)");
  std::size_t checked = 0;
  for (const fs::path& document : documents()) {
    const std::string text = text_of(document);
    for (const std::string& target : matches(text, link)) {
      EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document << " links to " << target;
      ++checked;
    }
    for (const std::string& named : matches(text, path)) {
      if (!starts_in_a_folder_of_ours(named)) continue;
      EXPECT_TRUE(fs::exists(root() / named)) << document << " names " << named;
      ++checked;
    }
  }
  EXPECT_GT(checked, 100U);
}

/// docs/architecture.md lists each room's doors, relative to the room.
TEST(Documents, TheArchitecturePageNamesEachDoor) {
  const std::string page = text_of(root() / "docs/architecture.md");
  std::ifstream doors(TELEPALP_BINARY_DIR "/where/doors.txt");
  std::size_t checked = 0;
  for (std::string room, door; doors >> room >> door;) {
    if (room == "room" || room == "why") continue;
    const bool of_an_inner_room = door.starts_with("proto/wire/mcap/") && room == "proto/wire";
    if (of_an_inner_room) continue;
    EXPECT_NE(page.find("`" + door.substr(room.size() + 1) + "`"), std::string::npos)
        << "docs/architecture.md does not name the door " << door;
    ++checked;
  }
  EXPECT_GT(checked, 50U);
}

/// The text of `page` from the heading `from` to the heading `to`.
std::string section(const std::string& page, const std::string& from, const std::string& to) {
  const std::size_t begin = page.find("\n" + from);
  return page.substr(begin, page.find("\n" + to, begin) - begin);
}

/// docs/architecture.md walks through the code file by file. A path starts at the repository or in haptic_station/; a
/// name without a folder lies in the folder of the file before it.
TEST(Documents, TheWalkThroughsNameFilesThatExist) {
  const std::string page = text_of(root() / "docs/architecture.md");
  for (const auto& [from, to] : {std::pair{"## The life of a frame", "## The life of a tick"},
                                 std::pair{"## The life of a tick", "## Rooms and doors"}}) {
    const std::vector<std::string> named =
        matches(section(page, from, to), std::regex(R"(`([a-z0-9_/]+\.(?:h|cpp))`)"));
    EXPECT_GE(named.size(), 14U) << from;
    fs::path folder;
    for (const std::string& name : named) {
      fs::path file = root() / name;
      if (name.find('/') == std::string::npos) file = folder / name;
      if (!fs::exists(file)) file = root() / "haptic_station" / name;
      EXPECT_TRUE(fs::exists(file)) << from << " names " << name;
      folder = file.parent_path();
    }
  }
}

/// The names Suite.Test of all tests in C++.
std::set<std::string> all_tests() {
  const std::regex test(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(root() / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), test), end; match != end; ++match)
      names.insert((*match)[1].str() + "." + (*match)[2].str());
  }
  return names;
}

TEST(Documents, EachBadInputHasATestThatExists) {
  const std::string page = text_of(root() / "docs/bad-input.md");
  const std::set<std::string> tests = all_tests();
  for (const std::string& named : matches(page, std::regex(R"(`([A-Z]\w+\.[A-Z]\w+)`)")))
    EXPECT_TRUE(tests.contains(named)) << "docs/bad-input.md names " << named;
  const std::string in_browser = text_of(root() / "tests/end_to_end/keys_browser_test.mjs");
  for (const std::string& number : matches(page, std::regex("`keys_browser`: (bad input [0-9]+)")))
    EXPECT_NE(in_browser.find(number + ":"), std::string::npos) << number;
  constexpr std::size_t kRows = 36;
  EXPECT_EQ(matches(page, std::regex(R"((?:^|\n)\| ([0-9]+) \| [^\n]*`[^\n]*`)")).size(), kRows);
}

}  // namespace
