// Microphone and loudspeaker of the room, through the real ALSA library. A configuration file of ALSA makes its devices
// files or nothing, or takes them away.

#include "server/voice/room_voice.h"

#include <alsa/asoundlib.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/executor_work_guard.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "proto/wire/voice/voice_message.h"
#include "support/speech/voice_packets.h"
#include "tests/support/speech.h"
#include "tests/support/spoken_messages.h"

namespace telepalp::voice {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t kSaid = 250;  // frames of speech in the file that a microphone gives; 5 s

/// ALSA's configuration with a device `room` whose microphone gives `heard`, and whose loudspeaker writes to `played`.
class Room : public testing::Test {
 protected:
  Room() : folder_(std::filesystem::path(testing::TempDir()) / ("room" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream said(folder_ / "said.raw", std::ios::binary);
    for (std::uint32_t number = 0; number < kSaid; ++number)
      for (const float sample : support::speech(number)) {
        const auto value = static_cast<std::int16_t>(sample * 32'767.0F);
        said.write(reinterpret_cast<const char*>(&value), sizeof value);
      }
    connect();
    ::setenv("ALSA_CONFIG_PATH", (folder_ / "asoundrc").c_str(), 1);
    snd_config_update_free_global();
  }
  ~Room() override {
    voice_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// The device is there from now on.
  void connect() { write_config("pcm.room { type asym capture.pcm room_in playback.pcm room_out }\n"); }
  /// The device is not there from now on.
  void take_away() { write_config(""); }

  void start(RoomVoice::Options options = {}) {
    options.device = "room";
    options.floor = floor_;
    options.log = [this](const std::string& line) { log_.push_back(line); };
    listener_ = hub_.join("listener", "test", [] {});
    hub_.subscribe(listener_, {std::string(wire::kPatientVoice.name)});
    voice_ = std::make_unique<RoomVoice>(io_, hub_, clock_, options);
  }
  template <class Done>
  bool run_until(Done done, std::chrono::seconds limit = 10s) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!done() && std::chrono::steady_clock::now() < end) {
      io_.run_one_for(10ms);
      while (auto message = hub_.next(listener_)) {
        const auto frame = wire::read_voice_frame(*message->payload);
        EXPECT_TRUE(frame) << "what is published is speech";
        if (frame) spoken_.push_back(*frame);
      }
    }
    return done();
  }
  void run_for(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    (void)run_until([&] { return std::chrono::steady_clock::now() >= end; });
  }
  void command(const std::string& json, bool works = true) {
    bool answered = false;
    voice_->resource().change(json, "technician", [&](const Result<void>& done) {
      answered = true;
      EXPECT_EQ(done.ok(), works) << json;
    });
    EXPECT_TRUE(answered);
  }
  [[nodiscard]] std::vector<float> played() const {
    std::ifstream file(folder_ / "played.raw", std::ios::binary);
    std::vector<float> samples;
    for (std::int16_t value; file.read(reinterpret_cast<char*>(&value), sizeof value);)
      samples.push_back(static_cast<float>(value) / 32'768.0F);
    return samples;
  }
  /// The sound of the messages, decoded; all frames in order.
  [[nodiscard]] std::vector<float> decoded() const {
    codec::VoiceDecoder decoder;
    std::vector<float> samples;
    for (const msg::VoiceFrame& frame : spoken_) {
      const auto block = decoder.decode(std::as_bytes(std::span(frame.opus())));
      EXPECT_TRUE(block);
      if (block) samples.insert(samples.end(), block->begin(), block->end());
    }
    return samples;
  }
  static std::vector<float> said(std::uint32_t from, std::uint32_t until) {
    std::vector<float> samples;
    for (std::uint32_t number = from; number < until; ++number) {
      const codec::VoiceSamples frame = support::speech(number);
      samples.insert(samples.end(), frame.begin(), frame.end());
    }
    return samples;
  }

  hub::Hub hub_;
  std::shared_ptr<VoiceFloor> floor_ = std::make_shared<VoiceFloor>();
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  std::vector<msg::VoiceFrame> spoken_;
  std::vector<std::string> log_;
  std::unique_ptr<RoomVoice> voice_;

 private:
  void write_config(const std::string& device) {
    std::ofstream(folder_ / "asoundrc.new") << "pcm.nothing { type null }\n"
                                            << "pcm.room_in { type file slave.pcm nothing file /dev/null infile \""
                                            << (folder_ / "said.raw").string() << "\" format raw }\n"
                                            << "pcm.room_out { type file slave.pcm nothing file \""
                                            << (folder_ / "played.raw").string() << "\" format raw }\n"
                                            << device;
    std::filesystem::rename(folder_ / "asoundrc.new", folder_ / "asoundrc");
  }

  std::filesystem::path folder_;
  boost::asio::io_context io_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stays_{io_.get_executor()};
  hub::SubscriberId listener_ = 0;
};

TEST_F(Room, BeginsClosedAndSaysNothing) {
  start();
  run_for(600ms);
  EXPECT_FALSE(voice_->state().open());
  EXPECT_FALSE(voice_->state().hears());
  EXPECT_TRUE(spoken_.empty());
  EXPECT_EQ(voice_->state().microphone_problem(), "");
  EXPECT_NE(voice_->metrics().find("telepalp_room_microphone_open 0\n"), std::string::npos);
}

TEST_F(Room, WhatTheRoomSaysIsPublishedAsItWasSaidInTheStepOfTime) {
  start();
  command("{\"open\": true}");
  const SessionTime from = clock_.now();
  ASSERT_TRUE(run_until([&] { return spoken_.size() >= 150; }));
  const double took_s = to_seconds(clock_.now() - from);
  EXPECT_GT(took_s, 2.5) << "a file is not faster than time";
  EXPECT_LT(took_s, 5.0);
  EXPECT_TRUE(voice_->state().hears());
  std::uint32_t expected = spoken_.front().number();
  for (const msg::VoiceFrame& frame : spoken_) {
    EXPECT_EQ(frame.number(), expected++);
    EXPECT_EQ(frame.begun(), spoken_.front().number());
    EXPECT_EQ(frame.earlier_size(), static_cast<int>(std::min<std::uint32_t>(6, frame.number() - frame.begun())));
  }
  EXPECT_GT(support::aligned(said(0, 140), decoded(), 2'000).correlation, 0.8) << "sample by sample, after Opus";
  const auto first = session_time(static_cast<std::int64_t>(spoken_.front().captured_ns()));
  EXPECT_LT(std::abs(to_seconds(first - from)), 0.3) << "and knows when it was said";
  EXPECT_NE(voice_->metrics().find("telepalp_room_microphone_open 1\n"), std::string::npos);
}

TEST_F(Room, ClosedAgainItIsSilentAtOnceAndOpenedAgainItBeginsAnew) {
  start({.is_open = true});
  ASSERT_TRUE(run_until([&] { return spoken_.size() >= 20; }));
  command("{\"open\": false}");
  spoken_.clear();
  run_for(500ms);
  EXPECT_TRUE(spoken_.empty());
  EXPECT_FALSE(voice_->state().hears());
  command("{\"open\": true}");
  ASSERT_TRUE(run_until([&] { return spoken_.size() >= 5; }));
  EXPECT_EQ(spoken_.front().begun(), spoken_.front().number());
  EXPECT_GE(spoken_.front().number(), 40u) << "numbers go on with time while it is closed";
  command("{\"open\": 3}", false);
  command("{}", false);
  command("[]", false);
}

TEST_F(Room, TheDoctorIsHeardInTheRoomAsItWasSaid) {
  start();
  ASSERT_TRUE(run_until([&] { return !played().empty(); }));
  const std::vector<wire::Message> words = support::spoken_messages(wire::kDoctorVoice, clock_.now(), 0, 150, 9);
  for (const wire::Message& message : words) {
    const auto due = clock_.steady(message.published);
    (void)run_until([&] { return std::chrono::steady_clock::now() >= due; });
    hub_.publish(message);
  }
  run_for(500ms);
  voice_.reset();
  const std::vector<float> heard = played();
  const std::vector<float> spoken = said(0, 140);
  ASSERT_GT(heard.size(), spoken.size());
  // The loudspeaker was silent before: the words begin somewhere in what it played.
  const auto begin = std::ranges::find_if(heard, [](float one) { return std::abs(one) > 0.02F; });
  ASSERT_NE(begin, heard.end());
  const std::size_t from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(begin - heard.begin() - 4'000, 0));
  // On a busy machine the words wait in between, so each quarter may be shifted by another time.
  const std::size_t quarter = spoken.size() / 4;
  int clear = 0;
  for (std::size_t begun = 0; begun + quarter <= spoken.size(); begun += quarter) {
    if (from + begun + quarter > heard.size()) break;
    const auto said_then = std::span(spoken).subspan(begun, quarter);
    clear += support::aligned(said_then, std::span(heard).subspan(from + begun), 12'000).correlation > 0.7 ? 1 : 0;
  }
  EXPECT_GE(clear, 3) << "quarters that are heard as they were said";
}

TEST_F(Room, ADeviceThatIsNotThereIsSaidAndTriedAgain) {
  take_away();
  start({.is_open = true});
  ASSERT_TRUE(run_until(
      [&] { return !voice_->state().microphone_problem().empty() && !voice_->state().loudspeaker_problem().empty(); }));
  EXPECT_NE(voice_->state().microphone_problem().find("arecord -L"), std::string::npos)
      << voice_->state().microphone_problem();
  EXPECT_FALSE(voice_->state().hears());
  EXPECT_NE(voice_->metrics().find("telepalp_room_voice_problems 2\n"), std::string::npos);
  run_for(2500ms);
  EXPECT_LE(log_.size(), 2u) << "the same problem is said once";
  connect();
  ASSERT_TRUE(run_until([&] { return spoken_.size() > 10 && voice_->state().loudspeaker_problem().empty(); }))
      << voice_->state().microphone_problem();
  EXPECT_TRUE(voice_->state().hears());
  EXPECT_EQ(voice_->state().microphone_problem(), "");
}

TEST_F(Room, AClosedMicrophoneHasNoProblemAndOneThatIsOpenedAgainHas) {
  take_away();
  start();
  run_for(300ms);
  EXPECT_EQ(voice_->state().microphone_problem(), "");
  for (int times = 0; times < 2; ++times) {
    command("{\"open\": true}");
    ASSERT_TRUE(run_until([&] { return !voice_->state().microphone_problem().empty(); }));
    command("{\"open\": false}");
    run_for(200ms);
    EXPECT_EQ(voice_->state().microphone_problem(), "");
  }
}

TEST_F(Room, WhileAPageSpeaksAtThePatientTheRoomWaitsAndTwoTalkersAreNeverMixed) {
  constexpr std::uint64_t kPage = 1'000;
  start({.is_open = true});
  ASSERT_TRUE(run_until([&] { return spoken_.size() >= 5; }));
  EXPECT_FALSE(floor_->speaks(kPage, clock_.now())) << "the room holds the floor";
  command("{\"open\": false}");
  run_for(500ms);
  ASSERT_TRUE(floor_->speaks(kPage, clock_.now()));
  command("{\"open\": true}");
  spoken_.clear();
  const auto end = std::chrono::steady_clock::now() + 700ms;
  (void)run_until([&] {
    (void)floor_->speaks(kPage, clock_.now());
    return std::chrono::steady_clock::now() >= end;
  });
  EXPECT_TRUE(spoken_.empty());
  EXPECT_TRUE(run_until([&] { return spoken_.size() > 3; })) << "0.3 s after the page has ended, the room is heard";
}

TEST_F(Room, NobodySpeaksIntoARecordedSession) {
  start({.is_open = true});
  voice_->session_is_played(true);
  run_for(500ms);
  EXPECT_TRUE(spoken_.empty());
}

TEST(AlsaDevice, IsReadFromTheCommandLine) {
  EXPECT_EQ(room_device("alsa")->name, "default");
  EXPECT_FALSE(room_device("alsa")->is_open);
  EXPECT_EQ(room_device("alsa:hw:1,0")->name, "hw:1,0");
  EXPECT_EQ(room_device("open:alsa:hw:1,0")->name, "hw:1,0");
  EXPECT_TRUE(room_device("open:alsa")->is_open);
  for (const char* wrong : {"", "pulse", "alsa:", "alsax", "open:", "open:pulse"})
    EXPECT_FALSE(room_device(wrong)) << wrong;
}

}  // namespace
}  // namespace telepalp::voice
