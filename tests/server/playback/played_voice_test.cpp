// A recorded session with speech is played at other speeds, paused and moved, and its voices are heard as a page hears
// them: through the jitter buffer.

#include "server/playback/player/played_voice.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>

#include "codec/voice_playout.h"
#include "messages/camera.pb.h"
#include "proto/wire/voice/voice_message.h"
#include "server/playback/session_events.h"
#include "server/playback/session_player.h"
#include "support/speech/voice_packets.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/spoken_messages.h"

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kBegin = session_time(1'700'000'000'000'000'000);
constexpr std::uint32_t kFrames = 1000;  // 20 s
constexpr Nanoseconds kFrame = kVoiceFrameTime;

/// 20 s in which the doctor speaks, and a station says where it is each 40 ms.
std::filesystem::path session(const std::string& name) {
  static const std::vector<wire::Message> messages = [] {
    std::vector<wire::Message> all = support::spoken_messages(wire::kDoctorVoice, kBegin, 0, kFrames);
    for (std::uint32_t number = 0; number < kFrames; number += 2) {
      msg::StationState state;
      state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(kBegin + number * kFrame)));
      all.push_back(wire::make_message(wire::kStationState, kBegin + number * kFrame, state));
    }
    std::ranges::stable_sort(all, {}, &wire::Message::published);
    return all;
  }();
  const auto file = wire::samples::fresh_file(name + std::to_string(::getpid()) + ".mcap");
  EXPECT_TRUE(wire::samples::write_file(file, messages, {.bytes = 20'000}));
  return file;
}

/// A player with a listener, who hears 20 ms at a time.
class Listener {
 public:
  explicit Listener(PlaybackSpec spec) {
    auto opened = SessionPlayer::open(spec, false, clock_);
    EXPECT_TRUE(opened) << to_string(opened.error());
    player_ = std::move(opened).value();
    player_->start(io_, {.on_message = [this](const wire::Message& message) { came(message); }, .on_end = [] {}});
  }
  ~Listener() { player_->stop(); }

  void listen(std::chrono::milliseconds time) {
    const SessionTime end = clock_.now() + time;
    while (clock_.now() < end) {
      io_.run_one_for(2ms);
      for (; turn_ <= clock_.now(); turn_ += kFrame) {
        const codec::VoicePlayout::Played played = playout_.next(turn_);
        if (played.kind == codec::VoicePlayout::Kind::Voice) heard.push_back(played.number);
      }
    }
  }
  void command(const std::string& json) {
    const auto read = read_command(json);
    ASSERT_TRUE(read) << to_string(read.error());
    ASSERT_TRUE(player_->apply(*read));
    while (player_->state().pending()) io_.run_one_for(1ms);
    io_.poll();  // what was published before the command
    heard.clear();
    words = states = 0;
    offsets.clear();
  }
  [[nodiscard]] double position_s() const { return player_->state().position_s(); }

  std::vector<std::uint32_t> heard;  ///< numbers of the frames, since the last command
  int words = 0, states = 0;         ///< messages that came since the last command
  std::vector<Nanoseconds> offsets;  ///< of the played times from the recorded ones, words and states alike
  std::string status;

 private:
  void came(const wire::Message& message) {
    if (message.topic.name == wire::kDoctorVoice.name) {
      const auto frame = wire::read_voice_frame(*message.payload);
      ASSERT_TRUE(frame);
      ++words;
      offsets.push_back(session_time(static_cast<std::int64_t>(frame->captured_ns())) -
                        (kBegin + frame->number() * kFrame));
      for (codec::VoicePacket& packet : speech::packets_of(*frame)) playout_.add(std::move(packet), clock_.now());
    } else if (message.topic.name == wire::kStationState.name) {
      ++states;
      newest_state_ = message.published;
    } else if (message.topic.name == wire::kCameraStatus.name) {
      msg::CaptureStatus told;
      if (told.ParseFromString(*message.payload)) status = told.detail();
    }
  }

  boost::asio::io_context io_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stays_{io_.get_executor()};
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  codec::VoicePlayout playout_;
  SessionTime turn_ = clock_.now();
  SessionTime newest_state_{};
  std::unique_ptr<SessionPlayer> player_;
};

TEST(PlayedVoice, IsPlayedWithTheSessionUnlessItsTopicsAreLeftOut) {
  const auto file = session("voice_default");
  Listener listener({.file = file.string()});
  listener.listen(700ms);
  EXPECT_GT(listener.words, 20);
  EXPECT_GT(listener.heard.size(), 15u);
  Listener without({.file = file.string(), .topics = {"/station/*"}});
  without.listen(300ms);
  EXPECT_GT(without.states, 3);
  EXPECT_EQ(without.words, 0);
  std::filesystem::remove(file);
}

TEST(PlayedVoice, AtAnotherSpeedItIsSilentAndSaysSoAndAtSpeed1ItIsInStepAgain) {
  const auto file = session("voice_speeds");
  Listener listener({.file = file.string()});
  listener.listen(400ms);
  for (const char* speed : {"{\"speed\": 10}", "{\"speed\": 0.1}"}) {
    listener.command(speed);
    listener.listen(600ms);
    EXPECT_EQ(listener.words, 0) << speed;
    EXPECT_GT(listener.states, 0) << speed << ": the session goes on";
    EXPECT_LE(listener.heard.size(), 20u) << speed << ": only what was in the jitter buffer";
    EXPECT_NE(listener.status.find("without the voices"), std::string::npos) << listener.status;
  }
  listener.command("{\"speed\": 1}");
  const double from_s = listener.position_s();
  listener.listen(1000ms);
  ASSERT_GT(listener.heard.size(), 25u) << "it is heard again";
  EXPECT_EQ(listener.status.find("without the voices"), std::string::npos) << listener.status;
  EXPECT_NEAR(0.02 * listener.heard.front(), from_s, 0.1) << "from the present place on";
  EXPECT_NEAR(0.02 * listener.heard.back(), listener.position_s(), 0.35) << "and goes with the picture";
  const auto [least, most] = std::ranges::minmax(listener.offsets);
  EXPECT_LE(most - least, 1ms) << "one map of time for all words";
  std::filesystem::remove(file);
}

TEST(PlayedVoice, AfterASeekNothingOldIsHeard) {
  const auto file = session("voice_seek");
  Listener listener({.file = file.string(), .from_s = 8.0});
  listener.listen(500ms);
  for (const double to_s : {14.0, 2.0, 2.6, 1.2}) {  // far and near, forth and back
    listener.command("{\"seek_s\": " + std::to_string(to_s) + "}");
    listener.listen(600ms);
    const auto first =
        static_cast<std::uint32_t>(to_s / 0.02) - 1;  // the message of a frame comes when it has been said
    ASSERT_GT(listener.heard.size(), 10u) << to_s;
    const auto is_old = [&](std::uint32_t number) { return number < first || number > first + 40; };
    EXPECT_LE(std::ranges::count_if(listener.heard, is_old), 1)
        << "sought " << to_s << " s: at most the frame that was due";
    EXPECT_FALSE(is_old(listener.heard.back()));
  }
  std::filesystem::remove(file);
}

TEST(PlayedVoice, AfterAPauseItGoesOnWithoutAGapAndWithoutGuesses) {
  const auto file = session("voice_pause");
  Listener listener({.file = file.string()});
  listener.listen(500ms);
  listener.command("{\"play\": false}");
  listener.listen(1200ms);
  EXPECT_EQ(listener.words, 0);
  listener.command("{\"play\": true}");
  listener.listen(1000ms);
  ASSERT_GT(listener.heard.size(), 30u);
  const std::uint32_t span = listener.heard.back() - listener.heard.front() + 1;
  EXPECT_GE(listener.heard.size() + 5, span) << "frame after frame";
  std::filesystem::remove(file);
}

TEST(PlayedVoice, WordsFromBeforeAJumpAreCutOffTheFirstMessages) {
  PlayedVoice voice;
  const std::vector<wire::Message> messages = support::spoken_messages(wire::kPatientVoice, kBegin, 0, 20, 7);
  const auto played = [&](std::size_t at) {
    return wire::read_voice_frame(*voice.as_played(messages[at])->payload).value();
  };
  EXPECT_EQ(played(10).earlier_size(), 0);
  EXPECT_EQ(played(10).begun(), 10u);
  EXPECT_EQ(played(12).earlier_size(), 2);
  EXPECT_EQ(played(19).earlier_size(), 6);
  EXPECT_FALSE(voice.as_played(messages[8])) << "an older one that comes late";
  const std::uint64_t talker = played(19).talker();
  EXPECT_EQ(talker & 0xffffffffU, 7u);
  voice.jumped();
  EXPECT_NE(played(5).talker(), talker);
  EXPECT_EQ(played(5).begun(), 5u);
  wire::Message damaged = messages[6];
  damaged.payload = std::make_shared<const std::string>("\xff\xff");
  EXPECT_FALSE(voice.as_played(damaged));
}

}  // namespace
}  // namespace telepalp::playback
