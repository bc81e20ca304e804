// Topics with predicted frames in the hub. The payload of each message is its number.

#include <gtest/gtest.h>

#include "server/hub/hub.h"

namespace telepalp::server {
namespace {

wire::Message frame(int number, bool is_key) {
  return {wire::kCameraDepth, session_time(number), std::make_shared<const std::string>(std::to_string(number)), 0,
          is_key};
}

/// A hub whose camera makes a key frame when asked, and subscribers that can be slow.
struct Stage {
  hub::Hub hub;
  int asked = 0;
  int published = 0;

  Stage() {
    hub.on_key_frame_request([this](std::string_view topic) {
      EXPECT_EQ(topic, wire::kCameraDepth.name);
      ++asked;
    });
  }
  hub::SubscriberId join() {
    const hub::SubscriberId id = hub.join("s", "", [] {});
    hub.subscribe(id, {"/camera/depth"});
    return id;
  }
  void key() { hub.publish(frame(++published, true)); }
  void dependent() { hub.publish(frame(++published, false)); }
  std::string taken(hub::SubscriberId id) {
    std::string numbers;
    while (const auto next = hub.next(id)) numbers += (numbers.empty() ? "" : " ") + *next->payload;
    return numbers;
  }
};

TEST(HubGroups, ANewSubscriberGetsNothingUntilAKeyFrameWhichIsRequestedAtOnce) {
  Stage stage;
  stage.key();
  stage.dependent();
  const hub::SubscriberId late = stage.join();
  EXPECT_EQ(stage.asked, 1);
  stage.dependent();
  EXPECT_EQ(stage.taken(late), "");
  stage.key();
  stage.dependent();
  EXPECT_EQ(stage.taken(late), "4 5");
  EXPECT_EQ(stage.hub.subscriber_counts().front().dropped(), 1u);
}

TEST(HubGroups, TwoWhoJoinTogetherAskOnceAndFollowFromTheSameKeyFrame) {
  Stage stage;
  stage.key();
  stage.dependent();
  const hub::SubscriberId first = stage.join();
  stage.dependent();
  const hub::SubscriberId second = stage.join();
  stage.dependent();
  EXPECT_EQ(stage.asked, 1);
  stage.key();
  stage.dependent();
  EXPECT_EQ(stage.taken(first), "5 6");
  EXPECT_EQ(stage.taken(second), "5 6");
}

TEST(HubGroups, ASlowSubscriberNeverGetsAFrameWithoutItsReference) {
  Stage stage;
  const hub::SubscriberId slow = stage.join();
  stage.key();
  stage.dependent();
  stage.dependent();  // no room: this frame and those predicted from it are dropped
  stage.dependent();
  EXPECT_EQ(stage.asked, 0);
  EXPECT_EQ(stage.taken(slow), "1 2");
  EXPECT_EQ(stage.asked, 1);
  stage.dependent();
  EXPECT_EQ(stage.taken(slow), "");
  stage.key();
  stage.dependent();
  EXPECT_EQ(stage.taken(slow), "6 7");
  const hub::Hub::TopicCount count = stage.hub.topic_counts().at(wire::kCameraDepth.name);
  EXPECT_EQ(count.dropped, 3u);
  EXPECT_EQ(count.sent + count.dropped, count.published);
}

TEST(HubGroups, ASubscriberThatReadsNothingCausesNoKeyFrames) {
  Stage stage;
  (void)stage.join();
  stage.key();
  for (int i = 0; i < 100; ++i) stage.dependent();
  stage.key();
  for (int i = 0; i < 100; ++i) stage.dependent();
  EXPECT_EQ(stage.asked, 0);
}

TEST(HubGroups, AKeyFrameOvertakesTheKeyFrameThatWaitsWithAllThatDependsOnIt) {
  Stage stage;
  const hub::SubscriberId stalled = stage.join();
  stage.key();
  stage.dependent();
  stage.key();
  EXPECT_EQ(stage.taken(stalled), "3");
  EXPECT_EQ(stage.hub.topic_counts().at(wire::kCameraDepth.name).dropped, 2u);
}

TEST(HubGroups, ASlowSubscriberDoesNotAffectOthers) {
  Stage stage;
  (void)stage.join();
  const hub::SubscriberId quick = stage.join();
  stage.key();
  std::string all = stage.taken(quick);
  for (int i = 0; i < 6; ++i) {
    stage.dependent();
    all += " " + stage.taken(quick);
  }
  EXPECT_EQ(all, "1 2 3 4 5 6 7");
}

TEST(HubGroups, ASubscriberWithoutReferenceGetsAKeyFrameNext) {
  Stage stage;
  const hub::SubscriberId id = stage.join();
  stage.key();
  stage.dependent();
  EXPECT_EQ(stage.taken(id), "1 2");
  stage.hub.request_key_frame(id, wire::kCameraDepth, session_time(2));
  EXPECT_EQ(stage.asked, 1);
  stage.dependent();
  EXPECT_EQ(stage.taken(id), "");
  stage.key();
  EXPECT_EQ(stage.taken(id), "4");
}

TEST(HubGroups, MessagesAreDroppedForASubscriberThatLostItsReference) {
  Stage stage;
  const hub::SubscriberId id = stage.join();
  stage.key();
  EXPECT_EQ(stage.taken(id), "1");
  stage.dependent();
  stage.dependent();
  stage.hub.request_key_frame(id, wire::kCameraDepth, session_time(2));
  EXPECT_EQ(stage.taken(id), "");
  const hub::Hub::TopicCount count = stage.hub.topic_counts().at(wire::kCameraDepth.name);
  EXPECT_EQ(count.dropped, 2u);
  EXPECT_EQ(count.sent + count.dropped, count.published);
}

TEST(HubGroups, ASecondRequestBeforeTheKeyFrameHasNoEffect) {
  Stage stage;
  const hub::SubscriberId id = stage.join();
  stage.key();
  stage.dependent();
  for (int i = 0; i < 1000; ++i) stage.hub.request_key_frame(id, wire::kCameraDepth, session_time(2));
  EXPECT_EQ(stage.asked, 1);
  stage.key();
  stage.hub.request_key_frame(id, wire::kCameraDepth, session_time(2));  // requested before the key frame came
  EXPECT_EQ(stage.asked, 1);
}

TEST(HubGroups, AKeyFrameRequestNeedsASubscriptionToATopicWithPredictedFrames) {
  Stage stage;
  const hub::SubscriberId other = stage.hub.join("other", "", [] {});
  const hub::SubscriberId id = stage.join();
  stage.key();
  stage.hub.request_key_frame(id, wire::kCameraDepth, session_time(9));
  stage.dependent();
  stage.hub.request_key_frame(other, wire::kCameraDepth, session_time(9));
  stage.hub.request_key_frame(77, wire::kCameraDepth, session_time(9));
  EXPECT_EQ(stage.asked, 0);
}

TEST(HubGroups, APredictedFrameWhoseReferenceNeverCameIsOfferedToNobody) {
  Stage stage;
  const hub::SubscriberId id = stage.join();
  const auto numbered = [&](std::uint64_t number, bool is_key) {
    wire::Message message = frame(static_cast<int>(number), is_key);
    message.sequence = number;
    stage.hub.publish(message);
  };
  numbered(7, true);
  numbered(8, false);
  EXPECT_EQ(stage.taken(id), "7 8");
  numbered(10, false);
  EXPECT_EQ(stage.asked, 1);
  numbered(11, false);
  EXPECT_EQ(stage.taken(id), "");
  numbered(12, true);
  numbered(13, false);
  EXPECT_EQ(stage.taken(id), "12 13");
}

TEST(HubGroups, ARepeatedSubscriptionBeginsWithAKeyFrame) {
  Stage stage;
  const hub::SubscriberId id = stage.join();
  stage.key();
  stage.dependent();
  stage.hub.subscribe(id, {});
  stage.hub.subscribe(id, {"/camera/*"});
  EXPECT_EQ(stage.asked, 1);
  stage.dependent();
  stage.key();
  EXPECT_EQ(stage.taken(id), "4");
}

}  // namespace
}  // namespace telepalp::server
