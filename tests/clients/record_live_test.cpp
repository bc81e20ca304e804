// How a live recording is split, kept short, stopped by a full disk, and killed.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <string>

#include "clients/record/facts/session_facts.h"
#include "clients/record/live/amounts.h"
#include "clients/record/selection/topic_filter.h"
#include "clients/record/unfinished.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "tests/clients/recorder_stage.h"

namespace telepalp::record {
namespace {

using wire::samples::kStart_ns;

class LiveRecorder : public Recorder {
 protected:
  std::vector<std::filesystem::path> files_named(const char* extension) const {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      if (entry.path().extension() == extension) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
  }
  std::vector<std::filesystem::path> parts() const { return files_named(".mcap"); }
  static std::uint64_t messages_in(const std::filesystem::path& file) {
    auto reader = wire::McapReader::open(file);
    EXPECT_TRUE(reader) << file;
    return reader ? reader->summary().statistics.message_count : 0;
  }
  /// Ends the recorder when nothing more comes.
  int end(support::ChildProcess& recorder) const {
    std::this_thread::sleep_for(300ms);
    recorder.signal(SIGINT);
    return recorder.wait(20s).value_or(-1);
  }
};

/// Depth in groups of twelve frames at 30 Hz, and one camera model at the beginning.
std::vector<wire::Message> depth_in_groups(int frames) {
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 12});
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24, 800)};
  std::vector<wire::Message> messages{
      wire::make_message(wire::kCameraInfo, session_time(kStart_ns), foxglove::CameraCalibration())};
  for (int frame = 0; frame < frames; ++frame) {
    image.samples[static_cast<std::size_t>(frame) % image.samples.size()] = 700;
    codec::EncodedDepth encoded = encoder.encode(image);
    msg::DepthImage depth;
    depth.set_data(encoded.bytes);
    const SessionTime at = session_time(kStart_ns + std::int64_t{frame} * 33'333'333);
    messages.push_back(wire::make_message(wire::kCameraDepth, at, depth, encoded.key_frame));
  }
  return messages;
}

std::set<std::string> topics_in(const wire::McapReader& reader) {
  std::set<std::string> topics;
  for (const auto& [id, stored] : reader.summary().channels.all()) topics.insert(stored.channel.topic);
  return topics;
}

TEST_F(LiveRecorder, EachPartOfASplitRecordingIsASessionOfItsOwn) {
  Server server;
  const auto recorder = start(server, {"--split", "1s"});
  for (const wire::Message& message : depth_in_groups(120)) {
    server.publish(message);
    std::this_thread::sleep_for(10ms);  // the server keeps few images for a slow subscriber
  }
  EXPECT_EQ(end(*recorder), 0) << log();
  const auto files = parts();
  ASSERT_GE(files.size(), 3u) << log();
  EXPECT_EQ(files.front(), in("session.0001.mcap"));
  std::uint64_t depth_images = 0;
  for (const auto& file : files) {
    auto reader = wire::McapReader::open(file);
    ASSERT_TRUE(reader) << file;
    EXPECT_EQ(topics_in(*reader).size(), 2u) << "the camera model is repeated in " << file;
    reader->select({.topics = {"/camera/depth"}});
    codec::DepthDecoder decoder;
    for (auto next = reader->next(); next && *next; next = reader->next()) {
      msg::DepthImage image;
      ASSERT_TRUE(image.ParseFromString(*(*next)->payload));
      ASSERT_TRUE(decoder.decode(std::as_bytes(std::span(image.data())))) << file << ", image " << depth_images;
      ++depth_images;
    }
  }
  EXPECT_EQ(depth_images, 120u) << "no image is lost between two parts";
}

TEST_F(LiveRecorder, ALatchedMessageOfAnHourAgoDoesNotMakeTheSessionAnHourLong) {
  Server server;
  const SessionTime hour_ago = session_time(kStart_ns - 3'600'000'000'000);
  server.publish(wire::make_message(wire::kStationInside, hour_ago, msg::InnerStructures()));
  server.publish(depth_in_groups(1).front());  // a camera model, which a server sends each second
  const auto recorder = start(server, {"--split", "1s"});
  for (const wire::Message& message : depth_in_groups(60)) {
    server.publish(message);
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(end(*recorder), 0) << log();
  ASSERT_GE(parts().size(), 2u) << log();
  for (const auto& file : parts()) {
    auto reader = wire::McapReader::open(file);
    ASSERT_TRUE(reader) << file;
    const wire::mcap::Statistics& statistics = reader->summary().statistics;
    EXPECT_LT(statistics.message_end_time - statistics.message_start_time, 10'000'000'000u) << file;
    EXPECT_EQ(topics_in(*reader).size(), 3u) << "camera model, depth, inside: " << file;
  }
}

TEST_F(LiveRecorder, AFirstMessageOfAnHourAgoDoesNotMakeTheSessionAnHourLong) {
  Server server;
  const SessionTime hour_ago = session_time(kStart_ns - 3'600'000'000'000);
  server.publish(wire::make_message(wire::kStationInside, hour_ago, msg::InnerStructures()));
  const auto recorder = start(server, {"--topics", "/station/*"});
  std::this_thread::sleep_for(1200ms);  // the recorder writes to disk twice before the first message of now
  for (int i = 0; i < 100; ++i) {
    const SessionTime now = session_time(kStart_ns + std::int64_t{i} * 10'000'000);
    server.publish(wire::make_message(wire::kStationState, now, msg::StationState()));
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(end(*recorder), 0) << log();
  auto reader = wire::McapReader::open(session());
  ASSERT_TRUE(reader);
  const wire::mcap::Statistics& statistics = reader->summary().statistics;
  EXPECT_LT(statistics.message_end_time - statistics.message_start_time, 10'000'000'000u);
  EXPECT_EQ(reader->summary().channels.all().size(), 2u) << "inside and state";
}

TEST_F(LiveRecorder, ASplitBySizeKeepsFilesNearThatSize) {
  Server server;
  const auto recorder = start(server, {"--split", "100kB", "--topics", "/station/*"});
  publish_slowly(server, states(20));
  EXPECT_EQ(end(*recorder), 0) << log();
  std::uint64_t messages = 0;
  for (const auto& file : parts()) messages += messages_in(file);
  EXPECT_EQ(messages, 2000u);
}

TEST_F(LiveRecorder, KeepLastRemovesWhatIsOlderAndKeepsAtLeastThatMuch) {
  Server server;
  const auto recorder = start(server, {"--keep-last", "3s"});
  publish_slowly(server, states(12));
  EXPECT_EQ(end(*recorder), 0) << log();
  const auto files = parts();
  ASSERT_GE(files.size(), 3u);
  EXPECT_FALSE(std::filesystem::exists(in("session.0001.mcap")));
  std::uint64_t messages = 0;
  for (const auto& file : files) messages += messages_in(file);
  EXPECT_GE(messages, 300u);
  EXPECT_LE(messages, 510u) << "twelve seconds were published";
  EXPECT_NE(log().find(", " + std::to_string(messages) + " messages, "), std::string::npos) << log();
  auto last = wire::McapReader::open(files.back());
  EXPECT_EQ(last->summary().statistics.message_end_time, static_cast<std::uint64_t>(kStart_ns) + 11'990'000'000u);
}

TEST_F(LiveRecorder, AFullDiskRaisesAnAlarmAndTheRecordingGoesOnInANewFile) {
  Server server;
  // A limit on the size of a file fails like a full disk, and ends when the next file is begun.
  const std::string command = "trap '' XFSZ; ulimit -f 200; exec " + kRecorder.string() + " --connect " +
                              server.address() + " --out " + session().string() + " --ready-file " +
                              in("ready").string();
  support::ChildProcess recorder("/bin/bash", {"-c", command}, in("log"));
  ASSERT_EQ(support::await_ready(in("ready"), "recording"), session().string()) << log();
  const auto messages = wire::samples::session(12, 100);
  publish_slowly(server, messages);
  ASSERT_TRUE(wait_for([&] { return log().find("the recording goes on in") != std::string::npos; })) << log();
  publish_slowly(server, wire::samples::session(0.2, 500));
  EXPECT_EQ(end(recorder), 1) << "messages were lost";
  EXPECT_NE(log().find("ALARM: "), std::string::npos) << log();
  EXPECT_NE(log().find("fix: free space"), std::string::npos) << log();
  EXPECT_EQ(log().find("the server does not answer"), std::string::npos) << "the stream lives";
  for (const auto& partial : files_named(".partial")) {
    const auto finished = finish(partial);  // the disk did not take the index, too
    ASSERT_TRUE(finished) << to_string(finished.error());
  }
  std::uint64_t recorded = 0;
  for (const auto& file : parts()) {
    const auto facts = inspect(file);
    ASSERT_TRUE(facts) << file << ": " << to_string(facts.error());
    EXPECT_EQ(facts->damages_in_all, 0u) << file;
    recorded += facts->messages;
  }
  EXPECT_GE(parts().size(), 2u) << log();
  const std::string dropped = log().substr(log().rfind("; ", log().rfind(" messages were not recorded")) + 2);
  EXPECT_EQ(recorded + std::strtoull(dropped.c_str(), nullptr, 10), messages.size() + 32u) << log();
}

TEST_F(LiveRecorder, KilledAtRandomInstantsItLosesLessThanHalfASecondAndTheRepairMendsIt) {
  const char* const asked = std::getenv("TELEPALP_KILLS");  // 200 are run by hand; see docs/performance.md
  const int kills = asked == nullptr ? 5 : std::atoi(asked);
  // A machine that runs other tests may leave the recorder without processor time for long.
  const Nanoseconds most_lost = asked == nullptr ? Nanoseconds(10s) : Nanoseconds(500ms);
  std::mt19937 random(15);
  for (int kill = 0; kill < kills; ++kill) {
    std::filesystem::remove(in("ready"));
    std::filesystem::remove(session());
    Server server;
    const auto recorder = start(server);
    std::atomic<bool> ended = false;
    std::atomic<std::int64_t> published = 0;
    std::thread publisher([&] {
      while (!ended) {
        msg::StationState state;
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        server.publish(wire::make_message(wire::kStationState,
                                          session_time(std::chrono::duration_cast<Nanoseconds>(now).count()), state));
        ++published;
        std::this_thread::sleep_for(2ms);
      }
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 1200));
    const auto killed_at = std::chrono::duration_cast<Nanoseconds>(std::chrono::system_clock::now().time_since_epoch());
    recorder->signal(SIGKILL);
    EXPECT_EQ(recorder->wait(10s), 128 + SIGKILL);
    ended = true;
    publisher.join();
    const auto finished = finish(session().string() + ".partial");
    if (!finished) {
      EXPECT_LE(published, most_lost / 2ms) << "seed 15, kill " << kill << ": " << to_string(finished.error());
      std::filesystem::remove(session().string() + ".partial");
      continue;
    }
    const auto facts = inspect(session());
    ASSERT_TRUE(facts) << "seed 15, kill " << kill << ": " << to_string(facts.error());
    EXPECT_EQ(facts->damages_in_all, 0u);
    EXPECT_EQ(facts->topics.front().lost, 0u);
    const auto last_ns = wire::McapReader::open(session())->summary().statistics.message_end_time;
    EXPECT_LT(killed_at.count() - static_cast<std::int64_t>(last_ns), most_lost.count()) << "seed 15, kill " << kill;
  }
}

TEST_F(LiveRecorder, WritesWhoRecordedConsentAndAttachments) {
  Server server;
  std::ofstream(in("skin.scene.textproto")) << "name: \"skin\"";
  std::ofstream(in("report.html")) << "<p>report</p>";
  const auto recorder = start(server, {"--consent", "study 17, signed", "--scene", in("skin.scene.textproto"),
                                       "--attach", in("report.html"), "--seconds", "0.3"});
  EXPECT_EQ(recorder->wait(20s), 0) << log();
  const auto facts = inspect(session());
  ASSERT_TRUE(facts) << to_string(facts.error());
  EXPECT_EQ(facts->consent, "study 17, signed");
  EXPECT_TRUE(facts->recorded_by.starts_with("account ")) << facts->recorded_by;
  EXPECT_EQ(facts->attachments.size(), 2u);
  EXPECT_EQ(facts->recording.count("clock_uncertainty_us"), 1u);
  auto reader = wire::McapReader::open(session());
  EXPECT_EQ(reader->session()->scene, "name: \"skin\"");
  const auto report = reader->read(reader->summary().attachments[1]);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->data, "<p>report</p>");
  EXPECT_EQ(report->media_type, "text/html");
  EXPECT_EQ(run({"--out", in("b.mcap"), "--connect", server.address(), "--attach", in("none")}), 1);
  EXPECT_NE(log().find("cannot be attached"), std::string::npos) << log();
}

TEST(TopicFilter, PatternsIncludeAndExclude) {
  const TopicFilter filter("/station/*,/camera/depth,!*/ticks");
  EXPECT_TRUE(filter.matches("/station/state"));
  EXPECT_FALSE(filter.matches("/station/ticks"));
  EXPECT_TRUE(filter.matches("/camera/depth"));
  EXPECT_FALSE(filter.matches("/camera/color"));
  EXPECT_TRUE(TopicFilter("!/camera/*").matches("/clock"));
  EXPECT_FALSE(TopicFilter("!/camera/*").matches("/camera/color"));
  EXPECT_EQ(TopicFilter("/camera/[cd]*,/clock").subscription(), (std::vector<std::string>{"/camera/*", "/clock"}));
}

TEST(Amounts, AreReadWithTheirUnitsAndWrongOnesAreNamed) {
  EXPECT_EQ(parse_duration("90", "to").value(), 90s);
  EXPECT_EQ(parse_duration("1.5min", "to").value(), 90s);
  EXPECT_EQ(parse_duration("250ms", "to").value(), 250ms);
  EXPECT_EQ(parse_size("1.5MB", "split").value(), 1'500'000u);
  EXPECT_EQ(parse_size("1GiB", "split").value(), 1u << 30);
  EXPECT_TRUE(is_size("5MB"));
  EXPECT_TRUE(is_size("5M")) << "parse_size() then asks for a B";
  EXPECT_FALSE(is_size("5min"));
  for (const char* wrong : {"", "min", "-1s", "5 min", "nan", "1e30h", "5m"})
    EXPECT_FALSE(parse_duration(wrong, "to")) << wrong;
  for (const char* wrong : {"", "0MB", "-1B", "5XB", "1e40GB"}) EXPECT_FALSE(parse_size(wrong, "split")) << wrong;
}

}  // namespace
}  // namespace telepalp::record
