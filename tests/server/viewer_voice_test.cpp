// What a viewer says: its form, its rate, and who is heard where several speak at once.

#include "server/gateway/voice/viewer_voice.h"

#include <gtest/gtest.h>

#include "proto/wire/voice/voice_message.h"
#include "proto/words/voice/voice_packet.h"
#include "server/gateway/viewer_commands.h"
#include "server/voice/voice_floor.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

constexpr char kOneFrameOf20ms = 0x48;  // SILK wideband, 20 ms, one channel, one frame

std::string packet(std::size_t bytes = 60) { return kOneFrameOf20ms + std::string(bytes - 1, 'x'); }

msg::VoiceFrame frame(std::uint32_t number, int earlier = 0) {
  msg::VoiceFrame made;
  made.set_captured_ns(1'000'000'000);
  made.set_talker(999);
  made.set_number(number);
  made.set_begun(3);
  made.set_opus(packet());
  for (int i = 0; i < earlier; ++i) made.add_earlier(packet());
  return made;
}

std::string voice_data(const std::string& payload) { return std::string("\x01\x05\0\0\0", 5) + payload; }

SessionTime at(Nanoseconds since) { return session_time(1'000'000'000) + since; }

TEST(ViewerVoice, WhatIsSaidIsPublishedUnderTheViewersOwnNumber) {
  gateway::ViewerVoice voice;
  const auto message = voice.hear(wire::kDoctorVoice, frame(10, 4).SerializeAsString(), 7, at(0ms));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->topic.name, "/doctor/voice");
  const auto read = wire::read_voice_frame(*message->payload);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->talker(), 7u) << "whatever the viewer wrote";
  EXPECT_EQ(read->number(), 10u);
  EXPECT_EQ(read->earlier_size(), 4);
  EXPECT_EQ(read->captured_ns(), 1'000'000'000u);
}

TEST(ViewerVoice, ATimeFarFromTheServersIsReplaced) {
  gateway::ViewerVoice voice;
  msg::VoiceFrame wrong = frame(10);
  wrong.set_captured_ns(UINT64_MAX);
  const auto message = voice.hear(wire::kPatientVoice, wrong.SerializeAsString(), 7, at(500ms));
  ASSERT_TRUE(message);
  EXPECT_EQ(wire::read_voice_frame(*message->payload)->captured_ns(), 1'500'000'000u);
}

TEST(ViewerVoice, MessagesThatAreNoSpeechAreRefused) {
  struct Case {
    const char* what;
    std::string payload;
  };
  msg::VoiceFrame stereo = frame(10), cut = frame(10), large = frame(10),
                  many = frame(20, wire::kMaxEarlierVoicePackets + 1), before = frame(4, 2), backwards = frame(10),
                  damaged_repeat = frame(10, 1);
  stereo.mutable_opus()->front() = static_cast<char>(kOneFrameOf20ms | 4);
  cut.set_opus("");
  large.set_opus(packet(kMaxVoicePacketBytes + 1));
  backwards.set_begun(11);
  *damaged_repeat.mutable_earlier(0) = std::string(1, '\xff');
  for (const Case& one :
       {Case{"two channels", stereo.SerializeAsString()}, Case{"an empty packet", cut.SerializeAsString()},
        Case{"a packet larger than any", large.SerializeAsString()},
        Case{"more repeated packets than any", many.SerializeAsString()},
        Case{"packets from before the microphone was opened", before.SerializeAsString()},
        Case{"a frame before the first", backwards.SerializeAsString()},
        Case{"a damaged repeated packet", damaged_repeat.SerializeAsString()}, Case{"no message", "\xff\xff"},
        Case{"nothing", ""}, Case{"a bomb", std::string(60'000, '\x2a')}}) {
    gateway::ViewerVoice voice;
    EXPECT_FALSE(voice.hear(wire::kPatientVoice, one.payload, 7, at(0ms))) << one.what;
    EXPECT_TRUE(voice.hear(wire::kPatientVoice, frame(10).SerializeAsString(), 7, at(1s))) << one.what;
  }
}

TEST(ViewerVoice, AMicrophonePassesForEverAndAFloodDoesNot) {
  gateway::ViewerVoice microphone, flood;
  const std::string words = frame(10).SerializeAsString();
  int flooded = 0;
  for (int i = 0; i < 10'000; ++i) {
    if (i < 1'000) {
      EXPECT_TRUE(microphone.hear(wire::kPatientVoice, words, 7, at(20ms * i)));
    }
    flooded += flood.hear(wire::kPatientVoice, words, 7, at(1ms * i)) ? 1 : 0;
  }
  EXPECT_LE(flooded, 50 + 600 + 1) << "a burst, and 60 a second in 10 s";
}

TEST(ViewerVoice, AReasonIsSaidOnceUntilAWordHasPassed) {
  gateway::ViewerVoice voice;
  int said = 0;
  const auto say = [&](const std::string&) { ++said; };
  for (int i = 0; i < 10; ++i) voice.refuse(gateway::kAnotherSpeaks, say);
  EXPECT_EQ(said, 1);
  EXPECT_TRUE(voice.hear(wire::kPatientVoice, frame(10).SerializeAsString(), 7, at(0ms)));
  voice.refuse(gateway::kAnotherSpeaks, say);
  EXPECT_EQ(said, 2);
}

TEST(ViewerVoice, EachSideNeedsARightOfItsOwn) {
  const auto doctor = gateway::operation_to_speak(wire::kDoctorVoice);
  const auto patient = gateway::operation_to_speak(wire::kPatientVoice);
  EXPECT_TRUE(keys::allows(keys::Role::Doctor, doctor));
  EXPECT_FALSE(keys::allows(keys::Role::Doctor, patient));
  EXPECT_TRUE(keys::allows(keys::Role::Technician, patient));
  EXPECT_FALSE(keys::allows(keys::Role::Technician, doctor));
  for (const keys::Role role : {keys::Role::Viewer, keys::Role::Qa})
    EXPECT_FALSE(keys::allows(role, doctor) || keys::allows(role, patient)) << keys::name(role);
}

TEST(VoiceFloor, TheFirstIsHeardUntilItHasBeenSilentFor300ms) {
  voice::VoiceFloor floor;
  EXPECT_TRUE(floor.speaks(1, at(0ms)));
  EXPECT_FALSE(floor.speaks(2, at(20ms)));
  EXPECT_TRUE(floor.speaks(1, at(40ms)));
  EXPECT_FALSE(floor.speaks(2, at(339ms))) << "a refused word does not keep the floor, nor take it";
  EXPECT_TRUE(floor.speaks(2, at(341ms)));
  EXPECT_FALSE(floor.speaks(1, at(350ms)));
  floor.leave(1);
  EXPECT_FALSE(floor.speaks(1, at(360ms))) << "only the holder's leaving gives up the floor";
  floor.leave(2);
  EXPECT_TRUE(floor.speaks(1, at(370ms)));
}

TEST(ViewerCommands, WordsAndHandsAreToldApartByTheirChannels) {
  gateway::ViewerCommands viewer;
  ASSERT_TRUE(viewer.advertise({5, "/doctor/voice", "protobuf"}));
  ASSERT_TRUE(viewer.advertise({6, "/viewer/hand", "protobuf"}));
  const std::string words = voice_data(frame(10).SerializeAsString());
  ASSERT_TRUE(viewer.spoken(words));
  EXPECT_EQ(viewer.spoken(words)->topic.name, "/doctor/voice");
  EXPECT_FALSE(viewer.hear(words, 1, at(0ms))) << "not a hand";
  EXPECT_FALSE(viewer.lets_go(words));
  msg::ViewerHand hand;
  hand.set_let_go(true);
  const std::string lets_go = std::string("\x01\x06\0\0\0", 5) + hand.SerializeAsString();
  EXPECT_FALSE(viewer.spoken(lets_go));
  EXPECT_TRUE(viewer.lets_go(lets_go));
  viewer.unadvertise(5);
  EXPECT_FALSE(viewer.spoken(words));
}

}  // namespace
}  // namespace telepalp::server
