#include "haptic_station/station/parts/depth_choice.h"

#include <gtest/gtest.h>

#include "proto/wire/topics.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;
using Topics = std::vector<std::string>;

const std::string kWhole(wire::kCameraDepth.name);
const std::string kWindow(wire::kCameraDepthWindow.name);
constexpr DepthChoice::TimePoint kStart{100s};

TEST(DepthChoice, TakesWholeImagesAloneUnlessWindowsAreAskedFor) {
  DepthChoice choice(false);
  EXPECT_EQ(choice.topics(), Topics{kWhole});
  EXPECT_FALSE(choice.asks_window());
  choice.connected(kStart);
  EXPECT_FALSE(choice.look(kStart + 1h));
  EXPECT_TRUE(choice.came(kWhole, kStart).is_used);
  EXPECT_FALSE(choice.came(kWindow, kStart).is_used);
}

TEST(DepthChoice, StaysWithWindowsWhileTheyCome) {
  DepthChoice choice(true);
  choice.connected(kStart);
  for (auto now = kStart; now < kStart + 1min; now += 1s) {
    const DepthChoice::Came came = choice.came(kWindow, now);
    EXPECT_TRUE(came.is_used);
    EXPECT_FALSE(came.topics_changed || came.said);
    EXPECT_FALSE(choice.look(now));
  }
  EXPECT_EQ(choice.topics(), Topics{kWindow});
  EXPECT_TRUE(choice.asks_window());
}

TEST(DepthChoice, AServerThatPublishesNoWindowIsFeltByItsWholeImagesAndTheStationSaysSo) {
  DepthChoice choice(true);
  choice.connected(kStart);
  EXPECT_FALSE(choice.look(kStart + 2s));
  EXPECT_TRUE(choice.look(kStart + 3s));
  EXPECT_EQ(choice.topics(), (Topics{kWhole, kWindow}));
  EXPECT_FALSE(choice.asks_window());
  const DepthChoice::Came first = choice.came(kWhole, kStart + 4s);
  EXPECT_TRUE(first.is_used);
  ASSERT_TRUE(first.said);
  EXPECT_NE(first.said->find("plays a session"), std::string::npos) << *first.said;
  EXPECT_FALSE(choice.came(kWhole, kStart + 5s).said) << "once";
}

TEST(DepthChoice, ReturnsToWindowsWhenTheyComeAndDropsWholeImagesThatAreOnTheWay) {
  DepthChoice choice(true);
  choice.connected(kStart);
  ASSERT_TRUE(choice.look(kStart + 3s));
  (void)choice.came(kWhole, kStart + 4s);
  const DepthChoice::Came came = choice.came(kWindow, kStart + 5s);
  EXPECT_TRUE(came.is_used && came.topics_changed);
  EXPECT_TRUE(came.said);
  EXPECT_EQ(choice.topics(), Topics{kWindow});
  EXPECT_FALSE(choice.came(kWhole, kStart + 5s).is_used);
  EXPECT_FALSE(choice.look(kStart + 7s));
}

TEST(DepthChoice, SaysNothingOfACameraThatIsSilentForAWhile) {
  DepthChoice choice(true);
  choice.connected(kStart);
  ASSERT_TRUE(choice.look(kStart + 10s));
  EXPECT_FALSE(choice.came(kWindow, kStart + 11s).said);
}

TEST(DepthChoice, WaitsAgainAfterAReconnection) {
  DepthChoice choice(true);
  choice.connected(kStart);
  (void)choice.came(kWindow, kStart);
  choice.connected(kStart + 1min);
  EXPECT_FALSE(choice.look(kStart + 1min));
}

}  // namespace
}  // namespace telepalp::station
