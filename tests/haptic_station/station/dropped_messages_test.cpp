#include "haptic_station/station/telemetry/dropped_messages.h"

#include <gtest/gtest.h>

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

const Error kNoPatient{.what = "the centre is not measured", .where = "/camera/depth", .fix = "aim the camera"};

TEST(DroppedMessages, AReasonThatRepeatsForHalfAMinuteIsLoggedEveryFiveSecondsWithItsCount) {
  DroppedMessages dropped;
  const DroppedMessages::TimePoint start{};
  std::vector<std::string> lines;
  for (int image = 0; image < 900; ++image) {
    Error error = kNoPatient;
    error.where += ", image " + std::to_string(image);
    if (auto line = dropped.add_image(error, start + image * 33ms)) lines.push_back(*line);
  }
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0], "depth image dropped: /camera/depth, image 0: the centre is not measured. fix: aim the camera");
  EXPECT_TRUE(lines[1].starts_with("depth image dropped, 153 so far for this reason: ")) << lines[1];
  EXPECT_EQ(dropped.images(), 900u);
  EXPECT_EQ(dropped.newest_image()->what, kNoPatient.what);
}

TEST(DroppedMessages, AnotherReasonIsLoggedAtOnceAndTwoThatAlternateDoNotFillTheLog) {
  DroppedMessages dropped;
  const Error damaged{.what = "is damaged", .where = "/camera/depth", .fix = "check the server"};
  int lines = 0;
  for (int image = 0; image < 300; ++image)
    lines += dropped.add_image(image % 2 == 0 ? kNoPatient : damaged, DroppedMessages::TimePoint{} + image * 10ms)
                 .has_value();
  EXPECT_EQ(lines, 2);
}

TEST(DroppedMessages, ManyDifferentReasonsTakeBoundedMemoryAndAreAllLogged) {
  DroppedMessages dropped;
  int lines = 0;
  for (int image = 0; image < 1000; ++image)
    lines += dropped.add_image({.what = "size " + std::to_string(image), .where = "", .fix = ""}, {}).has_value();
  EXPECT_EQ(lines, 1000);
}

TEST(DroppedMessages, AMessageThatIsCutShortIsNamedByItsTopicAndIsNoImage) {
  DroppedMessages dropped;
  EXPECT_EQ(dropped.add_unreadable("/camera/info", {}),
            "message dropped: /camera/info: the message is not of the type of /camera/info, or was cut short. fix: "
            "install the same version of telepalp at server and station");
  EXPECT_FALSE(dropped.add_unreadable("/camera/info", {}));
  EXPECT_TRUE(dropped.add_unreadable("/viewer/hand", {}));
  EXPECT_EQ(dropped.images(), 0u);
  EXPECT_FALSE(dropped.newest_image());
}

}  // namespace
}  // namespace telepalp::station
