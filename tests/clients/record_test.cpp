// telepalp-record as its user runs it: the program itself, and a real hub on loopback.

#include <gtest/gtest.h>

#include <atomic>
#include <boost/property_tree/json_parser.hpp>
#include <csignal>
#include <fstream>
#include <future>
#include <thread>

#include "clients/record/facts/session_facts.h"
#include "clients/record/live/disk_thread.h"
#include "clients/record/repair/repair.h"
#include "clients/record/unfinished.h"
#include "proto/wire/mcap/reader.h"
#include "tests/clients/recorder_stage.h"
#include "tests/support/terminal.h"

namespace telepalp::record {
namespace {

using namespace std::chrono_literals;
TEST_F(Recorder, DepthBeginsWithAFrameThatStandsAloneThoughItJoinsMidGroup) {
  Server server;
  const auto depth = [](int number, bool is_key) {
    const wire::Message message{wire::kCameraDepth, session_time(number), std::make_shared<const std::string>(), 0,
                                is_key};
    return message;
  };
  server.publish(depth(1, true));
  server.publish(depth(2, false));
  const auto recorder = start(server);
  publish_slowly(server, {depth(3, false), depth(4, false), depth(5, true), depth(6, false)});
  ASSERT_TRUE(wait_for([&] { return flushed_messages(session().string() + ".partial") >= 2; })) << log();
  recorder->signal(SIGINT);
  EXPECT_EQ(recorder->wait(20s), 0) << log();
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader.ok());
  const auto first = reader->next();
  ASSERT_TRUE(first.ok() && first->has_value());
  EXPECT_EQ((*first)->published, session_time(5));
}

TEST_F(Recorder, WritesWhatIsPublishedUntilItIsAskedToEnd) {
  Server server;
  const auto recorder = start(server);
  const auto messages = states(1);
  publish_slowly(server, messages);
  ASSERT_TRUE(wait_for([&] { return flushed_messages(session().string() + ".partial") == messages.size(); }));
  recorder->signal(SIGINT);
  EXPECT_EQ(recorder->wait(10s), 0) << log();
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader) << to_string(reader.error());
  for (const wire::Message& message : messages) {
    const auto next = reader->next();
    ASSERT_TRUE(next && *next);
    ASSERT_EQ(*(*next)->payload, *message.payload);
    ASSERT_EQ((*next)->published, message.published);
  }
  EXPECT_EQ(reader->session()->source, server.address());
  EXPECT_FALSE(std::filesystem::exists(session().string() + ".partial"));
}

TEST_F(Recorder, RecordsOnlyTheTopicsAskedForAndStopsWhenTheTimeIsUp) {
  Server server;
  const auto recorder = start(server, {"--topics", "/station/*,/clock", "--seconds", "0.6"});
  publish_slowly(server, wire::samples::session(0.1, 500));
  EXPECT_EQ(recorder->wait(10s), 0) << log();
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader) << log();
  ASSERT_EQ(reader->summary().channels.all().size(), 1u);
  EXPECT_EQ(reader->summary().channels.all().begin()->second.channel.topic, "/station/state");
  EXPECT_EQ(reader->summary().statistics.message_count, 10u);
}

TEST_F(Recorder, SurvivesAServerThatReturnsAndReportsTheGap) {
  auto server = std::make_unique<Server>();
  const std::uint16_t port = server->port();
  const auto recorder = start(*server);
  publish_slowly(*server, states(0.1));
  ASSERT_TRUE(wait_for([&] { return flushed_messages(session().string() + ".partial") == 10; }));
  server.reset();
  ASSERT_TRUE(wait_for([&] { return log().find("the server does not answer") != std::string::npos; })) << log();
  Server again(port);
  ASSERT_TRUE(wait_for([&] { return log().find("the server answers again") != std::string::npos; })) << log();
  publish_slowly(again, states(0.1));
  ASSERT_TRUE(wait_for([&] { return flushed_messages(session().string() + ".partial") == 20; }));
  recorder->signal(SIGTERM);
  EXPECT_EQ(recorder->wait(10s), 0);
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->summary().statistics.message_count, 20u);
  for (const wire::mcap::MetadataIndex& index : reader->summary().metadata)
    if (index.name == "telepalp.recording") {
      EXPECT_EQ(reader->read(index)->values.at("gaps"), "1");
    }
}

class BadInput31 : public Recorder {};
TEST_F(BadInput31, KilledWhileRecordingLosesNothingThatWasFlushedAndTheRepairFindsIt) {
  Server server;
  const auto recorder = start(server);
  const auto messages = states(0.5);
  publish_slowly(server, messages);
  const auto partial = session().string() + ".partial";
  ASSERT_TRUE(wait_for([&] { return flushed_messages(partial) == messages.size(); }));
  recorder->signal(SIGKILL);
  EXPECT_EQ(recorder->wait(10s), 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(session()));
  EXPECT_EQ(run({"info", partial}), 1);
  EXPECT_NE(log().find("fix: telepalp-record repair " + partial), std::string::npos) << log();
  const std::string as_killed = bytes_of(partial);
  EXPECT_EQ(run({"repair", partial, "--out", in("copy.mcap")}), 0) << log();
  EXPECT_NE(log().find("copy.mcap: recovered 50 messages; the end of the file is missing"), std::string::npos) << log();
  EXPECT_EQ(bytes_of(partial), as_killed);
  EXPECT_EQ(run({"repair", partial}), 0) << log();
  EXPECT_NE(log().find("was not completed by its recorder; the file is complete now, with 50 messages"),
            std::string::npos)
      << log();
  EXPECT_FALSE(std::filesystem::exists(partial));
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->summary().statistics.message_count, messages.size());
  EXPECT_EQ(reader->session()->program, "telepalp-record");
}

TEST_F(Recorder, AsksAgainWithinASecondMeansTheSameAndTheFileIsWhole) {
  for (const auto pause : {0ms, 1ms, 5ms, 30ms, 300ms}) {
    const auto name = std::to_string(pause.count());
    Server server;
    support::Terminal terminal(
        {kRecorder, "--connect", server.address(), "--out", in(name + ".mcap"), "--ready-file", in(name + ".ready")});
    ASSERT_TRUE(support::await_ready(in(name + ".ready"), "recording")) << terminal.shown();
    publish_slowly(server, states(0.5));
    terminal.type(support::kCtrlC);
    std::this_thread::sleep_for(pause);
    ::kill(terminal.pid(), SIGTERM);
    terminal.type(support::kCtrlC);
    EXPECT_EQ(terminal.wait(10s), 0) << terminal.shown();
    auto reader = wire::McapReader::open(in(name + ".mcap"));
    ASSERT_TRUE(reader) << to_string(reader.error());
    EXPECT_GT(reader->summary().statistics.message_count, 0U);
  }
}

TEST_F(Recorder, AFileThatIsStillBeingRecordedIsNotFinishedByOthers) {
  Server server;
  const auto recorder = start(server);
  publish_slowly(server, states(0.5));
  const auto partial = session().string() + ".partial";
  ASSERT_TRUE(wait_for([&] { return flushed_messages(partial) == 50; }));
  for (const std::filesystem::path& asked : {session(), std::filesystem::path(partial)}) {
    const auto refused = unfinished(asked);
    ASSERT_EQ(refused, partial);
    const auto finished = finish(*refused);
    ASSERT_FALSE(finished.ok());
    EXPECT_EQ(finished.error().what, "is still being recorded");
  }
  recorder->signal(SIGINT);
  EXPECT_EQ(recorder->wait(10s), 0) << log();
  EXPECT_EQ(unfinished(session()), std::nullopt);
  EXPECT_EQ(wire::McapReader::open(session())->summary().statistics.message_count, 50U);
}

TEST_F(Recorder, AnUnfinishedFileThatIsDamagedElsewhereTooIsKept) {
  ASSERT_TRUE(wire::samples::write_file(session(), wire::samples::session(4, 500), {.bytes = 5000}));
  const auto chunk = wire::McapReader::open(session())->summary().chunks[4];
  std::string bytes = bytes_of(session());
  bytes[chunk.chunk_start_offset + chunk.chunk_length - 20] ^= 0x55;
  bytes.resize(bytes.size() * 3 / 4);
  std::filesystem::remove(session());
  const std::filesystem::path partial = session().string() + ".partial";
  std::ofstream(partial, std::ios::binary) << bytes;
  const auto finished = finish(partial);
  ASSERT_TRUE(finished) << to_string(finished.error());
  EXPECT_EQ(finished->damages.size(), 2U);
  EXPECT_EQ(bytes_of(partial), bytes);
  EXPECT_TRUE(wire::McapReader::open(session()));
  EXPECT_FALSE(finish(partial).ok()) << "session.mcap exists now and is nobody's to replace";
}

TEST_F(Recorder, NotesHowExactTheDepthIsThatItRecorded) {
  Server server;
  const auto recorder = start(server);
  msg::DepthImage image;
  image.set_format("bounded");
  image.mutable_bound()->set_least_m(0.001);
  image.mutable_bound()->set_per_m(0.00285);
  publish_slowly(server, {wire::make_message(wire::kCameraDepth, session_time(1), image, true)});
  const auto partial = session().string() + ".partial";
  ASSERT_TRUE(wait_for([&] { return flushed_messages(partial) == 1; }));
  std::filesystem::copy_file(partial, in("cut_off.mcap"));
  recorder->signal(SIGINT);
  EXPECT_EQ(recorder->wait(10s), 0) << log();
  EXPECT_EQ(run({"repair", in("cut_off.mcap")}), 0) << log();
  for (const auto& file : {session(), in("cut_off.repaired.mcap")}) {
    const auto facts = inspect(file);
    ASSERT_TRUE(facts) << to_string(facts.error());
    const std::string text = in_words(*facts);
    EXPECT_NE(text.find("\ndepth: bounded, off by up to 2.85 mm at 1 m\n"), std::string::npos) << text;
  }
  auto reader = wire::McapReader::open(session());
  const auto& all = reader->summary().metadata;
  const auto noted =
      std::find_if(all.begin(), all.end(), [](const auto& index) { return index.name == wire::kRecordingMetadata; });
  ASSERT_NE(noted, all.end());
  EXPECT_EQ(reader->read(*noted)->values.at("depth"), "bounded, off by up to 2.85 mm at 1 m");
}

TEST_F(Recorder, WithoutAServerItGivesUpAndLeavesNothingBehind) {
  EXPECT_EQ(run({"--connect", "127.0.0.1:1", "--out", session(), "--patience", "0.3"}), 1);
  EXPECT_NE(log().find("error: 127.0.0.1:1: does not answer"), std::string::npos) << log();
  EXPECT_FALSE(std::filesystem::exists(session()));
  EXPECT_FALSE(std::filesystem::exists(session().string() + ".partial"));
}

TEST_F(Recorder, AskedWronglyItExitsWithTwo) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"--out", session(), "--connect", "nowhere:none"}), 2);
  EXPECT_EQ(run({"--out", session(), "--seconds", "soon"}), 2);
  EXPECT_EQ(run({"--no-such-option"}), 2);
  EXPECT_EQ(run({"--out", session(), "--split", "999ms"}), 2);
  EXPECT_EQ(run({"--out", session(), "--keep-last", "0s"}), 2) << "it would delete the recording while it is made";
  EXPECT_NE(log().find("--keep-last: the time is shorter than 1 s. fix: "), std::string::npos) << log();
}

TEST_F(Recorder, AKeyThatCannotBeUsedIsAFailureAndNotAWrongCommandLine) {
  EXPECT_EQ(run({"--out", session(), "--key", in("none.key"), "--consent", "signed form"}), 1);
  EXPECT_NE(log().find("none.key: the key cannot be read"), std::string::npos) << log();
}

TEST_F(Recorder, AnExistingFileIsNotOverwritten) {
  std::ofstream(session()) << "mine";
  EXPECT_EQ(run({"--out", session(), "--connect", "127.0.0.1:1"}), 1);
  EXPECT_NE(log().find("exists already"), std::string::npos) << log();
  EXPECT_EQ(bytes_of(session()), "mine");
}

TEST_F(Recorder, DescribesAFile) {
  ASSERT_TRUE(wire::samples::write_file(session(), wire::samples::session(10, 500)));
  const auto facts = inspect(session());
  ASSERT_TRUE(facts) << to_string(facts.error());
  const std::string text = in_words(*facts);
  EXPECT_NE(text.find("10.0 s from the first message, which may have been sent before the recording began, to the "
                      "last; 1600 messages"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("made by telepalp-test 0.1.0 (abc1234) from synthetic"), std::string::npos) << text;
  EXPECT_NE(text.find("/station/state  telepalp.msg.StationState      1000    100.0"), std::string::npos) << text;
}

TEST_F(Recorder, DescribesAFileInJsonToo) {
  ASSERT_TRUE(wire::samples::write_file(session(), wire::samples::session(10, 500)));
  const std::string described = in("described").string();
  const std::string command = kRecorder.string() + " info " + session().string() + " --json > " + described;
  ASSERT_EQ(std::system(command.c_str()), 0);
  boost::property_tree::ptree json;
  boost::property_tree::read_json(described, json);
  EXPECT_EQ(json.get<int>("messages"), 1600);
  EXPECT_EQ(json.get<std::string>("source"), "synthetic");
  const auto& topics = json.get_child("topics");
  const auto state = std::find_if(topics.begin(), topics.end(), [](const auto& topic) {
    return topic.second.template get<std::string>("name") == "/station/state";
  });
  ASSERT_NE(state, topics.end());
  EXPECT_EQ(state->second.get<int>("messages"), 1000);
  EXPECT_NEAR(state->second.get<double>("rate_Hz"), 100.0, 0.5);
  EXPECT_EQ(run({"info", session(), "--json", "--json"}), 2) << "given twice";
  EXPECT_EQ(run({"info"}), 2) << "no file named";
}

TEST_F(Recorder, ARepairLeavesOutOnlyTheDamagedChunk) {
  ASSERT_TRUE(wire::samples::write_file(session(), wire::samples::session(4, 500), {.bytes = 5000}));
  std::string bytes = bytes_of(session());
  auto whole = wire::McapReader::open(session());
  ASSERT_TRUE(whole);
  const auto& chunk = whole->summary().chunks[4];
  bytes[chunk.chunk_start_offset + chunk.chunk_length - 20] ^= 0x55;
  std::ofstream(session(), std::ios::binary) << bytes;
  const auto report = repair(session(), repaired_name(session()));
  ASSERT_TRUE(report) << to_string(report.error());
  ASSERT_EQ(report->damages.size(), 1u);
  EXPECT_TRUE(report->damages[0].starts_with("chunk 4: ")) << report->damages[0];
  EXPECT_EQ(report->file, in("session.repaired.mcap"));
  auto repaired = wire::McapReader::open(report->file);
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->summary().statistics.message_count, report->messages);
  EXPECT_LT(report->messages, whole->summary().statistics.message_count);
  EXPECT_GT(report->messages, whole->summary().statistics.message_count * 3 / 4);
  EXPECT_EQ(bytes_of(session()), bytes);  // the damaged file is unchanged
}

TEST_F(Recorder, AWholeFileNeedsNoRepair) {
  ASSERT_TRUE(wire::samples::write_file(session(), wire::samples::session(1, 500)));
  EXPECT_EQ(run({"repair", session()}), 0);
  EXPECT_NE(log().find("is whole"), std::string::npos) << log();
  EXPECT_FALSE(std::filesystem::exists(in("session.repaired.mcap")));
}

TEST(DiskThread, ASlowDiskDropsWhatDoesNotFitCountsItByTopicAndNeverBlocksTheLink) {
  std::promise<void> disk_is_back;
  auto back = disk_is_back.get_future().share();
  std::atomic<int> written = 0;
  DiskThread disk({.write = [&](const wire::Message&) -> Result<void> {
                     back.wait();
                     ++written;
                     return {};
                   },
                   .flush = [] { return Result<void>{}; }},
                  10'000);
  const auto payload = std::make_shared<const std::string>(872, 'x');  // with overhead 1000 bytes
  int accepted = 0;
  for (int number = 0; number < 25; ++number)
    accepted += disk.offer({wire::kCameraDepth, session_time(number), payload, 0, true}) ? 1 : 0;
  EXPECT_EQ(accepted, 10);
  EXPECT_EQ(disk.counts().dropped.at("/camera/depth"), 15u);
  disk_is_back.set_value();
  EXPECT_TRUE(disk.finish());
  EXPECT_EQ(written, 10);
}

TEST(DiskThread, AFailedStoreReportsOneErrorAndGetsNoMoreMessages) {
  DiskThread disk({.write = [](const wire::Message&) -> Result<void> {
                     return Error{.what = "full", .where = "disk", .fix = "free space"};
                   },
                   .flush = [] { return Result<void>{}; }});
  const wire::Message message{wire::kClock, session_time(1), std::make_shared<const std::string>("x"), 0, true};
  EXPECT_TRUE(disk.offer(message));
  for (int tries = 0; tries < 500 && !disk.counts().failed; ++tries) std::this_thread::sleep_for(10ms);
  EXPECT_FALSE(disk.offer(message));
  const auto finished = disk.finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().what, "full");
}

}  // namespace
}  // namespace telepalp::record
