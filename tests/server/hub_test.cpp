#include <gtest/gtest.h>

#include "server/hub/hub.h"
#include "server/hub/server_stats.h"

namespace telepalp::server {
namespace {

wire::Message message(const wire::Topic& topic, int number) {
  return {topic, session_time(number), std::make_shared<const std::string>(std::to_string(number)), 0, true};
}

TEST(Hub, AllSubscribersShareOnePayload) {
  hub::Hub hub;
  const hub::SubscriberId a = hub.join("a", "", [] {});
  const hub::SubscriberId b = hub.join("b", "", [] {});
  hub.subscribe(a, {"/camera/*"});
  hub.subscribe(b, {"/camera/depth"});
  hub.publish(message(wire::kCameraDepth, 1));
  const auto to_a = hub.next(a);
  const auto to_b = hub.next(b);
  ASSERT_TRUE(to_a && to_b);
  EXPECT_EQ(to_a->payload.get(), to_b->payload.get());
}

TEST(Hub, ASecondCodingGoesOnlyToThoseWhoNameIt) {
  hub::Hub hub;
  const hub::SubscriberId all = hub.join("a recorder", "", [] {});
  const hub::SubscriberId thin = hub.join("a thin viewer", "", [] {});
  hub.subscribe(all, {"*", "/camera/*"});
  EXPECT_FALSE(hub.is_wanted(wire::kCameraColorVideo.name));
  hub.subscribe(thin, {wire::kCameraColorVideo.name.data()});
  EXPECT_TRUE(hub.is_wanted(wire::kCameraColorVideo.name));
  hub.publish(message(wire::kCameraColorVideo, 1));
  hub.publish(message(wire::kCameraColor, 2));
  ASSERT_TRUE(hub.next(thin));
  EXPECT_FALSE(hub.next(thin)) << "only the coding that it named";
  ASSERT_EQ(hub.next(all)->topic.name, wire::kCameraColor.name);
  EXPECT_FALSE(hub.next(all));
}

TEST(Hub, AStalledSubscriberLosesOnlyItsOwnOldImagesAndTheyAreCountedByTopic) {
  hub::Hub hub;
  const hub::SubscriberId stalled = hub.join("stalled", "", [] {});
  const hub::SubscriberId quick = hub.join("quick", "", [] {});
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

TEST(Hub, ServerStatsTellWhatOtherFlowsLeaveOfASubscribersLineUntilTheyEnd) {
  hub::Hub hub;
  const hub::SubscriberId crowded = hub.join("crowded", "", [] {});
  (void)hub.join("alone", "", [] {});
  const auto row = [&hub](int index) { return hub::server_stats(hub, {}, session_time(1)).subscribers(index); };
  hub.note_share(crowded, 1.2e6);
  EXPECT_EQ(row(0).share_b_per_s(), 1.2e6);
  EXPECT_FALSE(row(1).has_share_b_per_s());
  hub.note_share(crowded, std::nullopt);
  EXPECT_FALSE(row(0).has_share_b_per_s());
}

TEST(Hub, MessagesThatWaitWhenTheirSubscriberLeavesAreCountedAsDroppedForTcpAndForDatagrams) {
  hub::Hub hub;
  const hub::SubscriberId leaving = hub.join("leaving", "", [] {});
  hub.subscribe(leaving, {"*"});
  hub.send_by_datagram(leaving, true);
  hub.publish(message(wire::kStationState, 1));  // waits for a datagram
  hub.publish(message(wire::kClock, 2));         // waits for TCP
  hub.leave(leaving);
  EXPECT_EQ(hub.topic_counts().at(wire::kStationState.name).dropped, 1u);
  EXPECT_EQ(hub.topic_counts().at(wire::kClock.name).dropped, 1u);
  EXPECT_EQ(hub.waiting_bytes(), 0u);
}

TEST(Hub, AnEmptyQueueThatFillsWakesItsSubscriberOnce) {
  hub::Hub hub;
  int wakes = 0;
  const hub::SubscriberId id = hub.join("a", "", [&] { ++wakes; });
  hub.subscribe(id, {"/clock"});
  hub.publish(message(wire::kClock, 1));
  hub.publish(message(wire::kClock, 2));
  EXPECT_EQ(wakes, 1);
}

TEST(Hub, AStationTakesAHandAndNeitherARecorderNorAnotherViewerDoes) {
  hub::Hub hub;
  hub.subscribe(hub.join("recorder", "", [] {}), {"*"});
  hub.subscribe(hub.join("viewer", "", [] {}), {"/viewer/hand"});
  EXPECT_FALSE(hub.is_taken("/viewer/hand", "viewer"));
  const hub::SubscriberId station = hub.join("station", "", [] {});
  hub.subscribe(station, {"/camera/depth", "/viewer/hand"});
  EXPECT_TRUE(hub.is_taken("/viewer/hand", "viewer"));
  hub.leave(station);
  EXPECT_FALSE(hub.is_taken("/viewer/hand", "viewer"));
}

TEST(Hub, ALateSubscriberIsGivenTheCameraModel) {
  hub::Hub hub;
  hub.publish(message(wire::kCameraInfo, 7));
  const hub::SubscriberId late = hub.join("late", "", [] {});
  hub.subscribe(late, {"/camera/*"});
  const auto next = hub.next(late);
  ASSERT_TRUE(next);
  EXPECT_EQ(*next->payload, "7");
}

TEST(Hub, ASubscriberMissesATopicUntilItIsOfferedAMessage) {
  hub::Hub hub;
  EXPECT_FALSE(hub.is_missed("/camera/depth"));
  hub.subscribe(hub.join("plot", "", [] {}), {"/station/state"});
  EXPECT_FALSE(hub.is_missed("/camera/depth")) << "it did not subscribe to depth";
  hub.subscribe(hub.join("viewer", "", [] {}), {"/camera/*"});
  EXPECT_TRUE(hub.is_missed("/camera/depth"));
  hub.publish(message(wire::kCameraDepth, 1));
  EXPECT_FALSE(hub.is_missed("/camera/depth"));
}

TEST(Hub, ASubscriberThatLeftGetsNothing) {
  hub::Hub hub;
  const hub::SubscriberId id = hub.join("a", "", [] { FAIL(); });
  hub.subscribe(id, {"*"});
  hub.leave(id);
  hub.publish(message(wire::kClock, 1));
  EXPECT_FALSE(hub.next(id));
}

wire::Message weighing(const wire::Topic& topic, std::size_t bytes) {
  return {topic, session_time(1), std::make_shared<const std::string>(bytes, 'x'), 0, true};
}

constexpr std::size_t kMiB = std::size_t{1} << 20;

TEST(Hub, OneStalledSubscriberHoldsAMebibyteOfEachSmallTopicAndItsNewestMessageWhateverThatWeighs) {
  hub::Hub hub;
  const hub::SubscriberId stalled = hub.join("stalled", "", [] {});
  hub.subscribe(stalled, {"*"});
  for (int round = 0; round < 256; ++round) {
    hub.publish(weighing(wire::kStationEvents, kMiB / 4));
    hub.publish(weighing(wire::kStationStats, 3 * kMiB));
  }
  EXPECT_EQ(hub.waiting_bytes(), kMiB + 3 * kMiB);
  hub.leave(stalled);
  EXPECT_EQ(hub.waiting_bytes(), 0u);
}

TEST(Hub, AllSubscribersTogetherAreBoundedAndTheFullestGivesUpItsOldest) {
  hub::Hub hub;
  const hub::SubscriberId modest = hub.join("modest", "", [] {});
  hub.subscribe(modest, {"/station/state"});
  for (int number = 0; number < 100; ++number) {
    const hub::SubscriberId greedy = hub.join("greedy", "", [] {});
    hub.subscribe(greedy, {"/station/*"});
  }
  hub.publish(message(wire::kStationState, 1));
  for (int round = 0; round < 20; ++round)
    for (const wire::Topic& topic : {wire::kStationEvents, wire::kStationTicks, wire::kStationSurface}) {
      hub.publish(weighing(topic, kMiB / 8));
      ASSERT_LE(hub.waiting_bytes(), hub::Hub::kMaxWaitingBytes);
    }
  EXPECT_EQ(*hub.next(modest)->payload, "1");
}

TEST(Hub, TheCameraGoesFirstAndTheOthersGetAQuarterOfItsBytes) {
  hub::Hub hub;
  const hub::SubscriberId id = hub.join("doctor", "", [] {});
  hub.subscribe(id, {"*"});
  std::size_t camera_bytes = 0;
  std::size_t other_bytes = 0;
  for (int round = 0; round < 200; ++round) {  // a link that sends one message while two more arrive
    hub.publish(weighing(wire::kStationEvents, 10'000));
    hub.publish(weighing(wire::kCameraDepth, 100'000));
    const auto next = hub.next(id);
    if (round == 0) {
      EXPECT_EQ(next->topic.name, wire::kCameraDepth.name);
    }
    (next->topic.name == wire::kCameraDepth.name ? camera_bytes : other_bytes) += next->payload->size();
  }
  EXPECT_NEAR(static_cast<double>(other_bytes) / static_cast<double>(camera_bytes), 0.25, 0.02);
}

}  // namespace
}  // namespace telepalp::server
