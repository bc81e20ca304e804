// Speech that is heard with its picture: the delay that lip sync chooses, and the jitter buffer that keeps it.

#include "codec/lip_sync.h"

#include <gtest/gtest.h>

#include <cmath>

#include "codec/voice_playout.h"
#include "tests/support/speech.h"

namespace telepalp::codec {
namespace {

using namespace std::chrono_literals;

TEST(LipSync, SpeechWaitsForTheMiddlePictureAndNoPictureWaitsForSpeech) {
  LipSync lips;
  EXPECT_EQ(lips.delay(30ms), 0ms) << "before the first picture";
  for (int i = 0; i < 100; ++i) lips.shown(i % 10 == 0 ? 400ms : 90ms);
  EXPECT_EQ(lips.delay(30ms), 60ms) << "single late pictures do not count";
  EXPECT_EQ(lips.delay(150ms), 0ms) << "speech is late itself";
}

TEST(LipSync, TheNewestThreeSecondsCountAndASlowPictureIsNotAwaited) {
  LipSync lips;
  for (int i = 0; i < 90; ++i) lips.shown(300ms);
  EXPECT_EQ(lips.delay(20ms), LipSync::kMostHeld);
  for (int i = 0; i < 90; ++i) lips.shown(50ms);
  EXPECT_EQ(lips.delay(20ms), 30ms);
}

/// Speech that arrives 30 ms after it was said, on an even path, with pictures that are `picture` old. The age of each
/// frame when its sound begins, from 5 s on.
std::vector<Nanoseconds> ages_heard(Nanoseconds picture) {
  const SessionTime begin = session_time(0) + 1s;
  VoiceEncoder encoder;
  VoicePlayout playout;
  LipSync lips;
  std::vector<Nanoseconds> ages;
  for (std::uint32_t number = 0; number < 600; ++number) {
    const SessionTime spoken = begin + number * Nanoseconds(kVoiceFrameTime);
    const SessionTime arrived = spoken + kVoiceFrameTime + 30ms;
    playout.add(
        {.talker = 1, .number = number, .begun = 0, .opus = encoder.encode(support::speech(number)), .spoken = spoken},
        arrived);
    lips.shown(picture);
    EXPECT_TRUE(playout.fastest_age());
    playout.hold(lips.delay(*playout.fastest_age()));
    const SessionTime now = arrived + 7ms;
    const VoicePlayout::Played played = playout.next(now);
    if (number > 250 && played.kind == VoicePlayout::Kind::Voice)
      ages.push_back(now - (begin + played.number * Nanoseconds(kVoiceFrameTime)));
  }
  EXPECT_LE(playout.counts().concealed, 1u);
  return ages;
}

TEST(LipSync, ThroughTheJitterBufferSpeechIsAsOldAsItsPicture) {
  for (const Nanoseconds picture : {Nanoseconds(60ms), Nanoseconds(100ms), Nanoseconds(170ms)}) {
    const std::vector<Nanoseconds> ages = ages_heard(picture);
    ASSERT_GT(ages.size(), 300u);
    for (const Nanoseconds age : ages)
      ASSERT_LE(std::abs(to_milliseconds(age - picture)), 30.0)
          << to_milliseconds(age) << " ms, picture " << to_milliseconds(picture) << " ms";
  }
}

TEST(LipSync, SpeechThatKnowsNoTimeIsNotHeld) {
  VoicePlayout playout;
  VoiceEncoder encoder;
  playout.add({.talker = 1, .number = 0, .begun = 0, .opus = encoder.encode(support::speech(0))}, session_time(0) + 1s);
  EXPECT_FALSE(playout.fastest_age());
}

}  // namespace
}  // namespace telepalp::codec
