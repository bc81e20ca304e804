// Grades of camera images in the hub. The payload of each message is its text.

#include <gtest/gtest.h>

#include <string>

#include "server/hub/hub.h"

namespace telepalp::hub {
namespace {

using plan::Grade;

wire::Message image(const std::string& text, bool is_key = true, const wire::Topic& topic = wire::kCameraDepth) {
  return {topic, session_time(1), std::make_shared<const std::string>(text), 0, is_key};
}

/// A hub with two subscribers to everything.
struct Stage {
  Hub hub;
  int asked = 0;  // requests for a key frame
  SubscriberId hand = join();
  SubscriberId recorder = join();

  Stage() {
    hub.on_key_frame_request([this](std::string_view) { ++asked; });
  }
  SubscriberId join() {
    const SubscriberId id = hub.join("s", "", [] {});
    hub.subscribe(id, {"*"});
    return id;
  }
  /// What waits for the subscriber, as TEXT:NUMBER.
  std::string taken(SubscriberId id) {
    std::string all;
    while (const auto next = hub.next(id))
      all += (all.empty() ? "" : " ") + *next->payload + ":" + std::to_string(next->sequence);
    return all;
  }
};

TEST(HubGrades, EachSubscriberGetsItsGradeOfAnImageAndAllOfTheRest) {
  Stage stage;
  stage.hub.give(stage.hand, Grade::Touch);
  EXPECT_TRUE(stage.hub.is_wanted(wire::kCameraDepth.name, Grade::Touch));
  EXPECT_TRUE(stage.hub.is_wanted(wire::kCameraDepth.name, Grade::Full));
  EXPECT_FALSE(stage.hub.is_wanted(wire::kCameraDepth.name, Grade::View));
  stage.hub.publish(image("full"));
  stage.hub.publish(image("touch"), Grade::Touch);
  stage.hub.publish(image("view"), Grade::View);
  stage.hub.publish(image("status", true, wire::kCameraStatus));
  EXPECT_EQ(stage.taken(stage.hand), "touch:1 status:1");
  EXPECT_EQ(stage.taken(stage.recorder), "full:1 status:1");
}

TEST(HubGrades, TheNumbersOfASubscriberGoOnWhenItsGradeChanges) {
  Stage stage;
  for (const char* text : {"a", "b"}) stage.hub.publish(image(text));
  EXPECT_EQ(stage.taken(stage.hand), "a:1 b:2");
  stage.hub.give(stage.hand, Grade::Touch);
  stage.hub.publish(image("c"));
  for (const char* text : {"t", "u"}) stage.hub.publish(image(text), Grade::Touch);
  EXPECT_EQ(stage.taken(stage.hand), "t:3 u:4") << "a gap would look like a loss";
  stage.hub.give(stage.hand, Grade::Full);
  stage.hub.publish(image("d"));
  EXPECT_EQ(stage.taken(stage.hand), "d:5") << "a smaller number would look like an old image";
  EXPECT_EQ(stage.taken(stage.recorder), "c:3 d:4");
}

TEST(HubGrades, AfterAChangeAPredictedImageWaitsForAKeyFrameOfTheNewGrade) {
  Stage stage;
  stage.hub.publish(image("K"));
  stage.hub.publish(image("p", false));
  stage.hub.publish(image("TK"), Grade::Touch);
  stage.hub.publish(image("tp", false), Grade::Touch);
  EXPECT_EQ(stage.taken(stage.hand), "K:1 p:2");
  stage.asked = 0;
  stage.hub.give(stage.hand, Grade::Touch);
  EXPECT_EQ(stage.asked, 1);
  stage.hub.publish(image("tq", false), Grade::Touch);
  EXPECT_EQ(stage.taken(stage.hand), "") << "its reference was never sent to this subscriber";
  stage.hub.publish(image("TL"), Grade::Touch);
  stage.hub.publish(image("tr", false), Grade::Touch);
  EXPECT_EQ(stage.taken(stage.hand), "TL:4 tr:5");
}

TEST(HubGrades, AfterAMissedMessageAPredictedOneWaitsForAKeyFrameInEachGrade) {
  Stage stage;
  stage.hub.give(stage.hand, Grade::Touch);
  const auto numbered = [](const wire::Topic& topic, const char* text, std::uint64_t number, bool is_key) {
    wire::Message message = image(text, is_key, topic);
    message.sequence = number;
    return message;
  };
  stage.hub.publish(numbered(wire::kCameraDepth, "K", 1, true), Grade::Touch);
  stage.hub.publish(numbered(wire::kCameraDepth, "p", 3, false), Grade::Touch);  // 2 is missing
  stage.hub.publish(numbered(wire::kStationState, "S", 1, true));
  stage.hub.publish(numbered(wire::kStationState, "s", 3, false));
  EXPECT_EQ(stage.taken(stage.recorder), "S:1");
  EXPECT_EQ(stage.taken(stage.hand), "K:1 S:1");
}

TEST(HubGrades, OnlyImagesThatTheLineHadNoRoomForCountAsCrowdedOut) {
  Stage stage;
  for (int i = 0; i < 6; ++i) stage.hub.publish(image("k"));
  EXPECT_EQ(stage.hub.count_of(stage.hand).images, 6u);
  EXPECT_EQ(stage.hub.count_of(stage.hand).crowded_out, 4u) << "two wait";
  stage.hub.give(stage.hand, Grade::Touch);
  stage.hub.publish(image("p", false), Grade::Touch);
  EXPECT_EQ(stage.hub.count_of(stage.hand).images, 6u) << "it could not decode this one";
  EXPECT_EQ(stage.hub.count_of(stage.hand).crowded_out, 4u);
}

}  // namespace
}  // namespace telepalp::hub
