// A send queue whose deadline topics another carrier takes.

#include <gtest/gtest.h>

#include "proto/wire/send_queue.h"

namespace telepalp::wire {
namespace {

Message message(const Topic& topic, std::uint64_t sequence, bool key_frame = true) {
  return {topic, SessionTime{}, std::make_shared<const std::string>(std::to_string(sequence)), sequence, key_frame};
}

struct ApartQueue {
  SendQueue queue;
  std::vector<Message> gone;

  ApartQueue() { queue.set_apart(true); }
  std::string newest() {
    const auto next = queue.pop_newest(gone);
    return next ? std::string(next->topic.name) + " " + *next->payload : "none";
  }
};

TEST(ApartQueue, TcpTakesOnlyTheRest) {
  ApartQueue apart;
  apart.queue.push(message(kCameraDepth, 1));
  apart.queue.push(message(kCameraInfo, 2));
  apart.queue.push(message(kStationState, 3));
  EXPECT_EQ(*apart.queue.pop()->payload, "2");
  EXPECT_EQ(*apart.queue.pop()->payload, "3");
  EXPECT_FALSE(apart.queue.pop());
  EXPECT_FALSE(apart.queue.empty());
  EXPECT_EQ(apart.newest(), "/camera/depth 1");
  EXPECT_TRUE(apart.queue.empty());
}

TEST(ApartQueue, TheNewestIndependentImageGoesFirstAndOlderOnesAreDropped) {
  ApartQueue apart;
  apart.queue.push(message(kCameraDepth, 1));
  apart.queue.push(message(kCameraColor, 1));
  apart.queue.push(message(kCameraDepth, 2));
  EXPECT_EQ(apart.newest(), "/camera/depth 2");
  ASSERT_EQ(apart.gone.size(), 1U);
  EXPECT_EQ(apart.gone[0].sequence, 1U);
  EXPECT_EQ(apart.newest(), "/camera/color 1");
  EXPECT_EQ(apart.newest(), "none");
}

TEST(ApartQueue, APredictedFrameDoesNotOvertakeTheOneThatItNeeds) {
  ApartQueue apart;
  apart.queue.push(message(kCameraDepth, 1));
  apart.queue.push(message(kCameraDepth, 2, false));
  EXPECT_EQ(apart.newest(), "/camera/depth 1");
  EXPECT_EQ(apart.newest(), "/camera/depth 2");
  EXPECT_TRUE(apart.gone.empty());
}

TEST(ApartQueue, HoldsNoMoreThanTwoImagesOfATopic) {
  ApartQueue apart;
  for (std::uint64_t i = 1; i <= 100; ++i) apart.queue.push(message(kCameraDepth, i));
  EXPECT_EQ(apart.queue.size(), 2U);
}

}  // namespace
}  // namespace telepalp::wire
