#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/architecture/cpp_includes.h"
#include "tests/architecture/cpp_laws.h"

namespace telepalp::architecture {
namespace {

const std::vector<Rule> kRules{
    {"proto/words", {"proto/words"}},
    {"proto/impaired", {"proto/words", "proto/link", "proto/impaired"}},
    {"proto/link", {"proto/words", "proto/link"}},
    {"proto/keys", {"proto/words", "proto/keys"}},
    {"proto/ice", {"proto/words", "proto/ice", "messages"}},
    // The codec's byte decides of a message that does not say whether it is a key frame: see codec/unmarked.
    {"proto/wire",
     {"proto/words", "proto/keys", "proto/ice", "proto/link", "codec/unmarked", "proto/wire", "messages", "foxglove"}},
    {"support", {"proto/words", "support"}},
    // Sessions in a cluster are read and written like session files.
    {"support/session_store", {"proto/words", "proto/wire/mcap", "support/nats", "support/session_store"}},
    // Recorded speech is found by its sound.
    {"support/speech", {"proto/words", "proto/wire", "codec", "messages", "support/speech"}},
    {"codec", {"proto/words", "codec"}},
    {"server", {"proto", "support", "codec", "server", "messages", "foxglove"}},
    {"haptic_station/surface", {"proto/words", "codec/levels", "support/models", "haptic_station/surface"}},
    {"haptic_station/ports", {"proto/words", "haptic_station/ports"}},
    {"haptic_station/solids", {"proto/words", "support/isosurface", "haptic_station/solids"}},
    {"haptic_station/tissue", {"proto/words", "haptic_station/tissue"}},
    {"haptic_station/mechanism", {"proto/words", "haptic_station/mechanism", "haptic_station/solids"}},
    {"haptic_station/effects",
     {"proto/words", "haptic_station/ports", "haptic_station/solids", "haptic_station/tissue",
      "haptic_station/effects"}},
    {"haptic_station/ultrasound",
     {"proto/words", "haptic_station/solids", "haptic_station/effects", "haptic_station/ultrasound"}},
    {"haptic_station/control",
     {"proto/words", "haptic_station/ports", "haptic_station/effects", "haptic_station/control"}},
    {"haptic_station/device", {"proto", "support", "messages", "haptic_station/ports", "haptic_station/device"}},
    {"haptic_station/tracking",
     {"proto", "support", "messages", "haptic_station/ports", "haptic_station/device", "haptic_station/tracking"}},
    {"haptic_station/loop", {"proto/words", "haptic_station"}},
    {"haptic_station/core",
     {"proto/words", "proto/wire", "codec", "messages", "haptic_station/control", "haptic_station/effects",
      "haptic_station/loop", "haptic_station/solids", "haptic_station/surface", "haptic_station/tissue",
      "haptic_station/ultrasound", "haptic_station/core"}},
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
    // Simulated people work with the station's mechanism, tissue and scenes, and tell it in the style of the report.
    // A study with people drives a haptic device as the daemon does, and keeps each sitting in a session file.
    {"tools/study",
     {"proto/words", "proto/wire", "support", "codec", "messages", "haptic_station/control", "haptic_station/core",
      "haptic_station/device", "haptic_station/effects", "haptic_station/loop", "haptic_station/mechanism",
      "haptic_station/ports", "haptic_station/scenes", "haptic_station/station", "haptic_station/tissue",
      "clients/report", "tools/study"}},
};

/// Headers that the real-time part must not include: those of functions that can wait, and those of libraries that it
/// does not link.
const std::vector<std::string> kNotInRealTime{"<mutex>",  "<condition_variable>", "<thread>",
                                              "<future>", "boost/asio",           ".pb.h",
                                              "pcl/",     "<iostream>",           "<fstream>"};
const std::vector<std::string> kRealTimeFolders{"haptic_station/control", "haptic_station/loop"};

const std::vector<std::string> kThickLibraries{"pcl/", "OpenNI"};

/// What the laws judge. A test plants a violation in a copy.
struct House {
  Includes includes = all_includes();
  Rooms rooms = read_rooms();
  Namespaces namespaces = {};
};

const House& the_house() {
  static const House house = [] {
    House read;
    for (const auto& [file, unused] : read.includes) read.namespaces[file] = namespaces(file);
    return read;
  }();
  return house;
}

void expect_none(const Sentences& violations) {
  for (const std::string& sentence : violations) ADD_FAILURE() << sentence;
}

TEST(Architecture, EveryFileIncludesOnlyAllowedFolders) {
  expect_none(forbidden_includes(the_house().includes, kRules));
}

TEST(Architecture, EveryRoomIsEnteredByItsDoors) {
  ASSERT_FALSE(the_house().rooms.doors.empty());
  const Sentences exceptions = includes_past_the_doors(the_house().includes, the_house().rooms);
  expect_none(exceptions);
  std::cout << the_house().rooms.doors.size() << " rooms, " << exceptions.size() << " exceptions\n";
}

bool is_included_from_outside(const Includes& all, const std::string& header, const std::string& room) {
  return std::any_of(all.begin(), all.end(), [&](const auto& file) {
    return !is_below(file.first, room) &&
           std::find(file.second.begin(), file.second.end(), header) != file.second.end();
  });
}

/// Removes each door from its list in turn. The check above must then find the includes that use it.
TEST(Architecture, WithoutOneOfItsDoorsARoomFailsTheCheck) {
  const auto& [all, rooms, unused] = the_house();
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

TEST(Architecture, EveryDoorIsOpenedFromOutside) {
  Includes all = the_house().includes;
  for (const std::string& file : sources("tests")) all[file] = includes(file);
  for (const auto& [room, doors] : the_house().rooms.doors)
    for (const std::string& door : doors)
      EXPECT_TRUE(is_included_from_outside(all, door, room)) << door << " is a door that nobody opens";
}

TEST(Architecture, EveryRoomHasAFewDoorsOrAReason) {
  const Rooms& rooms = the_house().rooms;
  for (const auto& [room, doors] : rooms.doors) {
    std::cout << room << ":";
    for (const std::string& door : doors) std::cout << " " << door.substr(room.size() + 1);
    std::cout << (rooms.with_a_reason.contains(room) ? " (more than a few, with a reason)\n" : "\n");
  }
  expect_none(rooms_with_many_doors(rooms));
}

TEST(Architecture, EveryTargetIsInARoomThatNamesItsDoors) {
  expect_none(files_outside_rooms(the_house().includes, the_house().rooms));
}

TEST(Architecture, NoFolderIsCrowded) { expect_none(crowded_folders(the_house().includes)); }

TEST(Architecture, TheNamespaceOfARoomIsItsFoldersName) {
  std::size_t opened = 0;
  for (const auto& [file, names] : the_house().namespaces) opened += names.size();
  EXPECT_GT(opened, the_house().rooms.doors.size());
  expect_none(foreign_namespaces(the_house().namespaces, the_house().rooms));
}

TEST(Architecture, NoFolderDependsOnItselfThroughOthers) { expect_none(circles_of_folders(the_house().includes)); }

TEST(Architecture, NoRealTimeCodeCanWaitOrSerialise) {
  expect_none(banned_includes(the_house().includes, kRealTimeFolders, kNotInRealTime));
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
                                                "proto/wire/connection/incoming_channels.cpp"};

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

/// What a stage of the station's core may not have of its own: its driver gives it times, jobs and results.
TEST(Architecture, TheCoreHasNoThreadSocketClockOrFile) {
  const std::regex kClock("(steady|system|high_resolution)_clock|clock_gettime");
  for (const std::string& file : sources("haptic_station/core")) {
    for (const std::string& include : includes(file))
      for (const char* banned : {"<mutex>", "<condition_variable>", "<thread>", "<future>", "boost/asio", "<fstream>"})
        EXPECT_EQ(include.find(banned), std::string::npos) << file << " includes " << include;
    std::stringstream text;
    text << std::ifstream(root() / file).rdbuf();
    EXPECT_FALSE(std::regex_search(text.str(), kClock)) << file << " reads a clock";
  }
}

/// The sequence sample, decide, apply stands once, in rig_tick.h. The replay of a journal has no rig: it gives the loop
/// recorded samples.
TEST(Architecture, TheSequenceOfATickIsWrittenOnce) {
  const std::regex kTick(R"re(\bloop_?\.tick\()re");
  std::vector<std::string> found;
  for (const std::string& file : all_sources()) {
    std::stringstream text;
    text << std::ifstream(root() / file).rdbuf();
    if (std::regex_search(text.str(), kTick)) found.push_back(file);
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<std::string>{"haptic_station/core/journal/journal_replay.cpp",
                                             "haptic_station/loop/rig_tick.h"}));
}

/// Who builds a surface or a tick from their parts, instead of driving the stages of haptic_station/core; and who
/// decodes depth, instead of giving a stage the messages.
std::vector<std::string> past_the_stages(const std::string& file, const std::string& code) {
  static const std::regex kParts(R"re(\b(SurfaceBuilder|HapticLoop)\b|/(surface_builder|haptic_loop)\.h)re");
  static const std::regex kDecodes(R"re(\bDepthReader\b)re");
  std::vector<std::string> found;
  for (std::istringstream lines(code); lines;) {
    std::string line;
    std::getline(lines, line);
    if (std::regex_search(line, kParts) ||
        (std::regex_search(line, kDecodes) && file != "tools/replay/source/tape.cpp"))
      found.push_back(file + ": " + line);
  }
  return found;
}

/// The benchmark of a tick's and a snapshot's cost measures these two classes themselves.
constexpr const char* kMeasuresTheParts = "tests/bench/hand/cost.cpp";

TEST(Architecture, WhatSimulatesTheStationDrivesTheStagesOfItsCore) {
  for (const char* folder : {"tests/bench/hand", "tools/replay", "haptic_station/trials"}) {
    const std::vector<std::string> files = sources(folder);
    EXPECT_GT(files.size(), 5U) << folder;
    for (const std::string& file : files)
      if (file != kMeasuresTheParts)
        for (const std::string& place : past_the_stages(file, code_of(file))) ADD_FAILURE() << place;
  }
  EXPECT_FALSE(past_the_stages("tools/planted.cpp", "surface::SurfaceBuilder builder(settings);").empty());
  EXPECT_FALSE(past_the_stages("tools/planted.cpp", "codec::DepthReader reader;").empty());
  EXPECT_TRUE(past_the_stages("tools/replay/source/tape.cpp", "codec::DepthReader reader;").empty());
}

TEST(Architecture, AClientIsThin) { expect_none(banned_includes(the_house().includes, {"clients"}, kThickLibraries)); }

/// Violations of every law.
Sentences all_violations(const House& house) {
  Sentences all;
  for (const Sentences& one :
       {forbidden_includes(house.includes, kRules), includes_past_the_doors(house.includes, house.rooms),
        rooms_with_many_doors(house.rooms), files_outside_rooms(house.includes, house.rooms),
        crowded_folders(house.includes), foreign_namespaces(house.namespaces, house.rooms),
        circles_of_folders(house.includes), banned_includes(house.includes, kRealTimeFolders, kNotInRealTime),
        banned_includes(house.includes, {"clients"}, kThickLibraries)})
    all.insert(all.end(), one.begin(), one.end());
  return all;
}

/// A defect that somebody could commit, and the sentences that must name it.
struct Planted {
  const char* law;
  std::function<void(House&)> plant;
  Sentences sentences;
};

const std::vector<Planted> kPlanted{
    {"a folder includes only what its rule names",
     [](House& house) { house.includes["codec/depth.h"].push_back("support/program/json.h"); },
     {"codec/depth.h may not include support/program/json.h"}},
    {"a room is entered by its doors",
     [](House& house) { house.includes["server/main.cpp"].push_back("server/hub/queues.h"); },
     {"server/main.cpp passes by the doors of server/hub: server/hub/queues.h"}},
    {"a room has a few doors, or a reason",
     [](House& house) {
       for (const char* door : {"a.h", "b.h", "c.h", "d.h"}) house.rooms.doors["server/gateway"].insert(door);
     },
     {"server/gateway has 7 doors and no reason"}},
    {"a file is in a room",
     [](House& house) { house.includes["server/attic/odd.cpp"] = {}; },
     {"server/attic/odd.cpp is in no room"}},
    {"a folder is not crowded",
     [](House& house) {
       for (int i = 10; i < 36; ++i) house.includes["codec/stream/new/" + std::to_string(i) + ".cpp"] = {};
     },
     {"codec/stream/new has 26 files"}},
    {"the namespace is that of the room",
     [](House& house) { house.namespaces["server/hub/hub.h"].insert("telepalp::wire"); },
     {"server/hub/hub.h opens telepalp::wire"}},
    {"folders form no circle",
     [](House& house) {
       house.includes["codec/stream/new/a.h"] = {"codec/stream/old/b.h"};
       house.includes["codec/stream/old/b.h"] = {"codec/stream/new/a.h"};
     },
     {"a circle: codec/stream/new <- codec/stream/old <- codec/stream/new",
      "a circle: codec/stream/old <- codec/stream/new <- codec/stream/old"}},
    {"real-time code cannot wait",
     [](House& house) { house.includes["haptic_station/loop/tick.h"].push_back("<mutex>"); },
     {"haptic_station/loop/tick.h includes <mutex>"}},
    {"a client is thin",
     [](House& house) { house.includes["clients/view/main.cpp"].push_back("<pcl/point_cloud.h>"); },
     {"clients/view/main.cpp includes <pcl/point_cloud.h>"}},
};

TEST(Architecture, EachPlantedViolationIsFoundAlone) {
  for (const Planted& planted : kPlanted) {
    House house = the_house();
    planted.plant(house);
    EXPECT_EQ(all_violations(house), planted.sentences) << planted.law;
    std::cout << planted.law << ": " << planted.sentences.front() << "\n";
  }
}

}  // namespace
}  // namespace telepalp::architecture
