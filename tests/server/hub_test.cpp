#include <gtest/gtest.h>

#include "server/hub/hub.h"

namespace telepalp::server {
namespace {

wire::Message message(const wire::Topic& topic, int number) {
  return {topic, session_time(number), std::make_shared<const std::string>(std::to_string(number))};
}

TEST(Hub, AllSubscribersShareOnePayload) {
  Hub hub;
  const SubscriberId a = hub.join("a", "", [] {});
  const SubscriberId b = hub.join("b", "", [] {});
  hub.subscribe(a, {"/camera/*"});
  hub.subscribe(b, {"/camera/depth"});
  hub.publish(message(wire::kCameraDepth, 1));
  const auto to_a = hub.next(a);
  const auto to_b = hub.next(b);
  ASSERT_TRUE(to_a && to_b);
  EXPECT_EQ(to_a->payload.get(), to_b->payload.get());
}

TEST(Hub, AStalledSubscriberLosesOnlyItsOwnOldImagesAndTheyAreCountedByTopic) {
  Hub hub;
  const SubscriberId stalled = hub.join("stalled", "", [] {});
  const SubscriberId quick = hub.join("quick", "", [] {});
  hub.subscribe(stalled, {"*"});
  hub.subscribe(quick, {"*"});
  for (int number = 0; number < 10; ++number) {
    hub.publish(message(wire::kCameraDepth, number));
    EXPECT_EQ(*hub.next(quick)->payload, std::to_string(number));
    hub.publish(message(wire::kStationEvents, number));
    (void)hub.next(quick);
  }
  EXPECT_EQ(hub.topic_counts().at(wire::kCameraDepth.name).dropped, 8u);
  EXPECT_EQ(hub.topic_counts().at(wire::kStationEvents.name).dropped, 0u);
  int events = 0;
  std::string newest;
  while (const auto next = hub.next(stalled)) {
    if (next->topic.name == wire::kStationEvents.name) ++events;
    if (next->topic.name == wire::kCameraDepth.name) newest = *next->payload;
  }
  EXPECT_EQ(events, 10);
  EXPECT_EQ(newest, "9");
}

TEST(Hub, AnEmptyQueueThatFillsWakesItsSubscriberOnce) {
  Hub hub;
  int wakes = 0;
  const SubscriberId id = hub.join("a", "", [&] { ++wakes; });
  hub.subscribe(id, {"/clock"});
  hub.publish(message(wire::kClock, 1));
  hub.publish(message(wire::kClock, 2));
  EXPECT_EQ(wakes, 1);
}

TEST(Hub, AStationTakesAHandAndNeitherARecorderNorAnotherViewerDoes) {
  Hub hub;
  hub.subscribe(hub.join("recorder", "", [] {}), {"*"});
  hub.subscribe(hub.join("viewer", "", [] {}), {"/viewer/hand"});
  EXPECT_FALSE(hub.is_taken("/viewer/hand", "viewer"));
  const SubscriberId station = hub.join("station", "", [] {});
  hub.subscribe(station, {"/camera/depth", "/viewer/hand"});
  EXPECT_TRUE(hub.is_taken("/viewer/hand", "viewer"));
  hub.leave(station);
  EXPECT_FALSE(hub.is_taken("/viewer/hand", "viewer"));
}

TEST(Hub, ALateSubscriberIsGivenTheCameraModel) {
  Hub hub;
  hub.publish(message(wire::kCameraInfo, 7));
  const SubscriberId late = hub.join("late", "", [] {});
  hub.subscribe(late, {"/camera/*"});
  const auto next = hub.next(late);
  ASSERT_TRUE(next);
  EXPECT_EQ(*next->payload, "7");
}

TEST(Hub, WhatLeftIsSentNothing) {
  Hub hub;
  const SubscriberId id = hub.join("a", "", [] { FAIL(); });
  hub.subscribe(id, {"*"});
  hub.leave(id);
  hub.publish(message(wire::kClock, 1));
  EXPECT_FALSE(hub.next(id));
}

}  // namespace
}  // namespace telepalp::server
