#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
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
    {"proto/impaired", {"proto/words", "proto/impaired"}},
    {"proto/link", {"proto/words", "proto/link"}},
    {"proto/keys", {"proto/words", "proto/keys"}},
    // The codec's byte decides of a message that does not say whether it is a key frame: see codec/unmarked.
    {"proto/wire", {"proto/words", "proto/keys", "proto/link", "codec/unmarked", "proto/wire", "messages", "foxglove"}},
    {"support", {"proto/words", "support"}},
    {"codec", {"proto/words", "codec"}},
    {"server", {"proto", "support", "codec", "server", "messages", "foxglove"}},
    {"haptic_station/surface", {"proto/words", "codec/levels", "support/models", "haptic_station/surface"}},
    {"haptic_station/ports", {"proto/words", "haptic_station/ports"}},
    {"haptic_station/solids", {"proto/words", "support/isosurface", "haptic_station/solids"}},
    {"haptic_station/effects",
     {"proto/words", "haptic_station/ports", "haptic_station/solids", "haptic_station/effects"}},
    {"haptic_station/ultrasound",
     {"proto/words", "haptic_station/solids", "haptic_station/effects", "haptic_station/ultrasound"}},
    {"haptic_station/control",
     {"proto/words", "haptic_station/ports", "haptic_station/effects", "haptic_station/control"}},
    {"haptic_station/device", {"proto", "support", "messages", "haptic_station/ports", "haptic_station/device"}},
    {"haptic_station/tracking",
     {"proto", "support", "messages", "haptic_station/ports", "haptic_station/device", "haptic_station/tracking"}},
    {"haptic_station/loop", {"proto/words", "haptic_station"}},
    {"haptic_station", {"proto", "support", "codec", "haptic_station", "messages", "foxglove"}},
    {"clients", {"proto", "support", "codec", "clients", "messages", "foxglove"}},
    // It reads recordings as the server does, and it needs no camera.
    {"tools",
     {"proto", "support", "codec", "server/capture", "server/pipeline", "server/views", "tools", "messages",
      "foxglove"}},
    // It runs the code of both sites, and compares a run with a baseline as the report does.
    {"tools/replay",
     {"proto", "support", "codec", "server/capture", "server/pipeline", "haptic_station", "clients/report",
      "tools/replay", "messages", "foxglove"}},
};

/// Headers that the real-time part must not include: those of functions that can wait, and those of libraries that it
/// does not link.
const std::vector<std::string> kNotInRealTime{"<mutex>",  "<condition_variable>", "<thread>",
                                              "<future>", "boost/asio",           ".pb.h",
                                              "pcl/",     "<iostream>",           "<fstream>"};
const std::vector<std::string> kRealTimeFolders{"haptic_station/control", "haptic_station/loop"};

const std::vector<std::string> kSourceFolders{"proto",          "support", "codec", "server",
                                              "haptic_station", "clients", "tools"};
constexpr std::size_t kMostFilesInAFolder = 25;
constexpr std::size_t kMostDoors = 4;

fs::path root() { return TELEPALP_SOURCE_DIR; }

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

/// Paths of source files, relative to the repository.
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

/// The included names of a file. Names in angle brackets keep the brackets: <mutex>.
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

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

/// The rooms of the house, as the CMakeLists.txt files name them.
struct Rooms {
  std::map<std::string, std::set<std::string>> doors;  ///< folder to its doors
  std::set<std::string> with_a_reason;                 ///< rooms that state a reason for many doors
};

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

/// The most specific rule for a file.
const Rule* rule_for(const std::string& file) {
  const Rule* best = nullptr;
  for (const Rule& rule : kRules)
    if (is_below(file, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size())) best = &rule;
  return best;
}

TEST(Architecture, EveryFileIncludesOnlyAllowedFolders) {
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

using Includes = std::map<std::string, std::vector<std::string>>;  // file to what it includes of telepalp

Includes all_includes() {
  Includes all;
  for (const std::string& file : all_sources())
    for (std::string& include : includes(file))
      if (is_ours(include)) all[file].push_back(std::move(include));
  return all;
}

bool enters(const std::string& file, const std::string& include, const std::string& room) {
  return is_below(include, room) && !is_below(file, room);
}

/// Includes that enter a room by a header that is no door of it, as sentences. A file outside a room enters it by a
/// door of that room, and by one of each room around it.
std::vector<std::string> includes_past_the_doors(const Includes& all, const Rooms& rooms) {
  std::vector<std::string> found;
  for (const auto& [file, includes_of_file] : all)
    for (const std::string& include : includes_of_file)
      for (const auto& [room, doors] : rooms.doors)
        if (enters(file, include, room) && !doors.contains(include))
          found.push_back(file + " passes by the doors of " + room + ": " + include);
  return found;
}

TEST(Architecture, EveryRoomIsEnteredByItsDoors) {
  const Rooms rooms = read_rooms();
  ASSERT_FALSE(rooms.doors.empty());
  const std::vector<std::string> exceptions = includes_past_the_doors(all_includes(), rooms);
  for (const std::string& exception : exceptions) ADD_FAILURE() << exception;
  std::cout << rooms.doors.size() << " rooms, " << exceptions.size() << " exceptions\n";
}

bool is_included_from_outside(const Includes& all, const std::string& header, const std::string& room) {
  return std::any_of(all.begin(), all.end(), [&](const auto& file) {
    return !is_below(file.first, room) &&
           std::find(file.second.begin(), file.second.end(), header) != file.second.end();
  });
}

/// Removes each door from its list in turn. The check above must then find the includes that use it.
TEST(Architecture, WithoutOneOfItsDoorsARoomFailsTheCheck) {
  const Includes all = all_includes();
  const Rooms rooms = read_rooms();
  std::size_t missed = 0;
  for (const auto& [room, doors] : rooms.doors)
    for (const std::string& door : doors) {
      Rooms without = rooms;
      without.doors[room].erase(door);
      const std::vector<std::string> found = includes_past_the_doors(all, without);
      EXPECT_EQ(!found.empty(), is_included_from_outside(all, door, room)) << door;
      for (const std::string& sentence : found)
        EXPECT_TRUE(sentence.ends_with(" passes by the doors of " + room + ": " + door)) << sentence;
      if (!found.empty() && missed++ == 0) std::cout << "without " << door << ": " << found.front() << "\n";
    }
  EXPECT_GT(missed, rooms.doors.size());
  std::cout << missed << " doors are missed when they are removed\n";
}

TEST(Architecture, EveryRoomHasAFewDoorsOrAReason) {
  const Rooms rooms = read_rooms();
  for (const auto& [room, doors] : rooms.doors) {
    std::cout << room << ":";
    for (const std::string& door : doors) std::cout << " " << door.substr(room.size() + 1);
    std::cout << (rooms.with_a_reason.contains(room) ? " (more than a few, with a reason)\n" : "\n");
    EXPECT_TRUE(doors.size() <= kMostDoors || rooms.with_a_reason.contains(room)) << room;
  }
}

TEST(Architecture, EveryTargetIsInARoomThatNamesItsDoors) {
  const Rooms rooms = read_rooms();
  const auto in_a_room = [&](const std::string& file) {
    return std::any_of(rooms.doors.begin(), rooms.doors.end(),
                       [&](const auto& room) { return is_below(file, room.first); });
  };
  for (const std::string& file : all_sources()) {
    const bool is_main_of_a_program = folder_of(file).find('/') == std::string::npos;
    EXPECT_TRUE(is_main_of_a_program || in_a_room(file)) << file;
  }
}

TEST(Architecture, NoFolderIsCrowded) {
  std::map<std::string, std::size_t> files;
  for (const std::string& file : all_sources()) ++files[folder_of(file)];
  for (const auto& [folder, count] : files) EXPECT_LE(count, kMostFilesInAFolder) << folder;
}

/// Rooms whose namespace is not their folder's name.
const std::map<std::string, std::string> kOtherNamespaces{
    {"proto/words", "telepalp"},             // the vocabulary of all rooms
    {"proto/wire/mcap", "telepalp::wire"},   // its parts are in telepalp::wire::mcap
    {"tools/keys", "telepalp::keys_tool"}};  // proto/keys has the name

/// The namespaces that a file may open: those of the rooms around it. A room within a room may have its own.
std::set<std::string> allowed_namespaces(const std::string& file, const Rooms& rooms) {
  std::set<std::string> allowed;
  for (const auto& [room, doors] : rooms.doors) {
    if (!is_below(file, room)) continue;
    const auto other = kOtherNamespaces.find(room);
    allowed.insert(other != kOtherNamespaces.end() ? other->second : "telepalp::" + fs::path(room).filename().string());
  }
  return allowed;
}

/// The namespaces of telepalp that a file opens.
std::set<std::string> namespaces(const std::string& file) {
  static const std::regex kNamespace(R"re(^namespace (telepalp[a-z_:]*) \{)re");
  std::set<std::string> found;
  std::ifstream stream(root() / file);
  for (std::string line; std::getline(stream, line);)
    if (std::smatch match; std::regex_search(line, match, kNamespace)) found.insert(match[1]);
  return found;
}

TEST(Architecture, TheNamespaceOfARoomIsItsFoldersName) {
  const Rooms rooms = read_rooms();
  std::size_t checked = 0;
  for (const std::string& file : all_sources()) {
    const std::set<std::string> allowed = allowed_namespaces(file, rooms);
    if (allowed.empty()) continue;  // the main of a program
    for (const std::string& found : namespaces(file)) {
      EXPECT_TRUE(std::any_of(allowed.begin(), allowed.end(),
                              [&](const std::string& one) { return found == one || found.starts_with(one + "::"); }))
          << file << " opens " << found;
      ++checked;
    }
  }
  EXPECT_GT(checked, rooms.doors.size());
}

using Graph = std::map<std::string, std::set<std::string>>;

/// For each folder, the other folders that its files include.
Graph folder_graph() {
  Graph graph;
  for (const std::string& file : all_sources())
    for (const std::string& include : includes(file))
      if (is_ours(include) && folder_of(include) != folder_of(file)) graph[folder_of(file)].insert(folder_of(include));
  return graph;
}

/// A path from `folder` back to itself; empty without one.
std::vector<std::string> cycle_through(const Graph& graph, const std::string& folder) {
  std::map<std::string, std::string> came_from;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const std::string here = open.back();
    open.pop_back();
    const auto edges = graph.find(here);
    if (edges == graph.end()) continue;
    for (const std::string& next : edges->second) {
      if (!came_from.emplace(next, here).second) continue;
      if (next != folder) {
        open.push_back(next);
        continue;
      }
      std::vector<std::string> path{folder};
      for (std::string at = here; at != folder; at = came_from[at]) path.push_back(at);
      return path;
    }
  }
  return {};
}

TEST(Architecture, NoFolderDependsOnItselfThroughOthers) {
  const Graph graph = folder_graph();
  for (const auto& [folder, unused] : graph) {
    std::ostringstream path;
    for (const std::string& step : cycle_through(graph, folder)) path << " <- " << step;
    EXPECT_EQ(path.str(), "") << "a cycle between folders";
  }
}

TEST(Architecture, NoRealTimeCodeCanWaitOrSerialise) {
  for (const std::string& folder : kRealTimeFolders)
    for (const std::string& file : sources(folder))
      for (const std::string& include : includes(file))
        for (const std::string& banned : kNotInRealTime)
          EXPECT_EQ(include.find(banned), std::string::npos) << file << " includes " << include;
}

/// The text of a file without its comments.
std::string code_of(const std::string& file) {
  std::ifstream stream(root() / file);
  std::string code;
  for (std::string line; std::getline(stream, line);) code += line.substr(0, line.find("//")) + "\n";
  return code;
}

/// Where a message that does not say whether it is a key frame comes in: from an old file, and from an old peer.
const std::set<std::string> kEdgesOfOldMessages{"proto/wire/mcap/format/stored_message.cpp",
                                                "proto/wire/connection.cpp"};

/// The places in `code` that decide whether a message is a key frame, instead of asking wire::Message::key_frame: by a
/// comparison with the name of a topic in the same statement, or by parsing what the codec wrote.
std::vector<std::string> decisions_on_key_frames(const std::string& file, const std::string& code) {
  static const std::regex kStatement(R"re([^;{}]+)re");
  static const std::regex kComparesATopic(R"re((==|!=)\s*(wire::)?kCamera|kCamera\w+(\.name)?\s*(==|!=)|"/camera/)re");
  static const std::regex kKeyFrame(R"re(key_?frame|is_key|predict)re", std::regex::icase);
  static const std::regex kParses(R"re(codec::is_key_frame|is_key_frame\(std::as_bytes|\bsince_key\b)re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(code.begin(), code.end(), kStatement), end; at != end; ++at) {
    const std::string statement = at->str();
    const bool by_topic = std::regex_search(statement, kComparesATopic) && std::regex_search(statement, kKeyFrame);
    const bool by_old_rule = statement.find("is_unmarked_key_frame") != std::string::npos;
    if (by_topic || std::regex_search(statement, kParses) || (by_old_rule && !kEdgesOfOldMessages.contains(file)))
      found.push_back(file + ": " + statement);
  }
  return found;
}

/// The codec, the table of topics, and what shows a user the content of a packet.
bool may_decide_on_key_frames(const std::string& file) {
  return is_below(file, "codec") || file == "proto/wire/topics.h" || is_below(file, "tools/codec_tool");
}

TEST(Architecture, AMessageSaysWhetherItIsAKeyFrameAndNobodyElseDecidesIt) {
  std::vector<std::string> found;
  for (const std::string& file : all_sources())
    if (!may_decide_on_key_frames(file))
      for (std::string& place : decisions_on_key_frames(file, code_of(file))) found.push_back(std::move(place));
  for (const std::string& place : found) ADD_FAILURE() << place;
  std::cout << found.size() << " files outside codec and the topics' table decide on key frames\n";
}

TEST(Architecture, ADecisionOnKeyFramesByTopicOrByParsingFailsTheCheck) {
  for (const std::string planted :
       {"const bool is_predicted = message->topic.name == wire::kCameraDepth.name && !is_key_frame(*message);",
        "return image.ParseFromString(*message.payload) && "
        "codec::is_key_frame(std::as_bytes(std::span(image.data())));",
        "made.key_frame = is_key_frame(std::as_bytes(std::span(depth->data())));",
        "if (message.channel->channel.topic != wire::kCameraDepth.name || is_key_frame(message.record)) keep();",
        "return codec::is_unmarked_key_frame(payload);",
        "const bool predicted = topic.name.starts_with(\"/camera/depth\");"})
    EXPECT_EQ(decisions_on_key_frames("clients/planted.cpp", planted).size(), 1U) << planted;
  EXPECT_TRUE(decisions_on_key_frames("clients/good.cpp",
                                      "if (message.topic.predicted && message.key_frame) begin();"
                                      "if (message.topic.name == wire::kCameraDepth.name) show();")
                  .empty());
}

TEST(Architecture, AClientIsThin) {
  for (const std::string& file : sources("clients"))
    for (const std::string& include : includes(file)) {
      EXPECT_EQ(include.find("pcl/"), std::string::npos) << file;
      EXPECT_EQ(include.find("OpenNI"), std::string::npos) << file;
    }
}

}  // namespace
