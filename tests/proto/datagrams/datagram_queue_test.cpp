// A send queue whose deadline topics are sent by datagram.

#include <gtest/gtest.h>

#include "proto/wire/send_queue.h"

namespace telepalp::wire {
namespace {

Message message(const Topic& topic, std::uint64_t sequence, bool key_frame = true) {
  return {topic, SessionTime{}, std::make_shared<const std::string>(std::to_string(sequence)), sequence, key_frame};
}

struct DatagramQueue {
  SendQueue queue;
  std::vector<Message> gone;

  DatagramQueue() { queue.send_by_datagram(true); }
  std::string newest(Wanted wanted = Wanted::Any) {
    const auto next = queue.pop_newest(gone, wanted);
    return next ? std::string(next->topic.name) + " " + *next->payload : "none";
  }
};

TEST(DatagramQueue, TcpTakesOnlyTheRest) {
  DatagramQueue waiting;
  waiting.queue.push(message(kCameraDepth, 1));
  waiting.queue.push(message(kCameraInfo, 2));
  waiting.queue.push(message(kStationTicks, 3));
  EXPECT_EQ(*waiting.queue.pop()->payload, "2");
  EXPECT_EQ(*waiting.queue.pop()->payload, "3");
  EXPECT_FALSE(waiting.queue.pop());
  EXPECT_FALSE(waiting.queue.empty());
  EXPECT_EQ(waiting.newest(), "/camera/depth 1");
  EXPECT_TRUE(waiting.queue.empty());
}

TEST(DatagramQueue, TheNewestIndependentImageGoesFirstAndOlderOnesAreDropped) {
  DatagramQueue waiting;
  waiting.queue.push(message(kCameraDepth, 1));
  waiting.queue.push(message(kCameraColor, 1));
  waiting.queue.push(message(kCameraDepth, 2));
  EXPECT_EQ(waiting.newest(), "/camera/depth 2");
  ASSERT_EQ(waiting.gone.size(), 1U);
  EXPECT_EQ(waiting.gone[0].sequence, 1U);
  EXPECT_EQ(waiting.newest(), "/camera/color 1");
  EXPECT_EQ(waiting.newest(), "none");
}

TEST(DatagramQueue, APredictedFrameDoesNotOvertakeTheOneThatItNeeds) {
  DatagramQueue waiting;
  waiting.queue.push(message(kCameraDepth, 1));
  waiting.queue.push(message(kCameraDepth, 2, false));
  EXPECT_EQ(waiting.newest(), "/camera/depth 1");
  EXPECT_EQ(waiting.newest(), "/camera/depth 2");
  EXPECT_TRUE(waiting.gone.empty());
}

TEST(DatagramQueue, SpeechAndThenTheOtherUrgentTopicsGoBeforeImages) {
  DatagramQueue waiting;
  waiting.queue.push(message(kCameraDepth, 1));
  waiting.queue.push(message(kViewerHand, 2));
  waiting.queue.push(message(kDoctorVoice, 3));
  EXPECT_EQ(waiting.newest(), "/doctor/voice 3");
  EXPECT_EQ(waiting.newest(), "/viewer/hand 2");
  EXPECT_EQ(waiting.newest(Wanted::Urgent), "none") << "the image has to wait";
  EXPECT_EQ(waiting.newest(), "/camera/depth 1");
}

TEST(DatagramQueue, HoldsNoMoreThanTwoImagesOfATopic) {
  DatagramQueue waiting;
  for (std::uint64_t i = 1; i <= 100; ++i) waiting.queue.push(message(kCameraDepth, i));
  EXPECT_EQ(waiting.queue.size(), 2U);
}

TEST(DatagramQueue, OfStatesTheNewestGoesAndTheOlderOnesAreDropped) {
  DatagramQueue waiting;
  for (std::uint64_t i = 1; i <= 100; ++i) waiting.queue.push(message(kStationState, i));
  EXPECT_EQ(waiting.queue.size(), 2U);
  EXPECT_EQ(waiting.newest(), "/station/state 100");
  EXPECT_EQ(waiting.newest(), "none");
}

TEST(DatagramQueue, TheWireFixesTheChannelOfEachTopic) {
  const std::string_view expected[] = {"/camera/depth",  "/camera/color",       "/station/state",
                                       "/viewer/hand",   "/camera/color/video", "/camera/depth/window",
                                       "/patient/voice", "/doctor/voice"};
  for (std::uint8_t channel = 0; channel < std::size(expected); ++channel)
    EXPECT_EQ(topic_of_datagram_channel(channel).value_or(kClock).name, expected[channel]);
  for (int channel = 8; channel < 256; ++channel)
    EXPECT_FALSE(topic_of_datagram_channel(static_cast<std::uint8_t>(channel))) << channel;
}

TEST(DatagramQueue, OverTcpStatesWaitForTwoAndAHalfSeconds) {
  SendQueue queue;
  for (std::uint64_t i = 1; i <= 300; ++i) queue.push(message(kStationState, i));
  EXPECT_EQ(queue.size(), 256U);
}

TEST(DatagramQueue, WhatGoesByDatagramIsNotCountedAsWaitingForTcp) {
  DatagramQueue waiting;
  waiting.queue.push(message(kStationState, 1));
  waiting.queue.push(message(kCameraDepth, 1));
  EXPECT_EQ(waiting.queue.other_bytes(), 0U);
  EXPECT_FALSE(waiting.queue.drop_of_largest());
  waiting.queue.push(message(kStationTicks, 7));
  EXPECT_EQ(waiting.queue.other_bytes(), 1U);
  waiting.queue.remove_if([](const Message&) { return true; });
  EXPECT_EQ(waiting.queue.other_bytes(), 0U);
  EXPECT_TRUE(waiting.queue.empty());
}

}  // namespace
}  // namespace telepalp::wire
