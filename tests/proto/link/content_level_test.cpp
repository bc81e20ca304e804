#include "proto/link/path/content_level.h"

#include <gtest/gtest.h>

#include <vector>

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

/// Chooses five times a second, as the server does.
class Chooser {
 public:
  explicit Chooser(ContentLevel::Line line) : line_(line) {}
  ContentLevel::Line& line() noexcept { return line_; }
  void during(Nanoseconds span) {
    for (const SessionTime until = now_ + span; now_ < until; now_ += 200ms) level_.step(line_, now_);
  }
  [[nodiscard]] std::size_t level() const noexcept { return level_.level(); }

 private:
  ContentLevel level_;
  ContentLevel::Line line_;
  SessionTime now_{1h};
};

TEST(ContentLevel, ImagesAreAsAskedTwoSecondsAfterTheOtherFlowsHaveGone) {
  Chooser chooser({.share_B_per_s = 1e6, .demand_B_per_s = 3e6});
  EXPECT_EQ(chooser.level(), 0U);
  chooser.during(2s);
  EXPECT_EQ(chooser.level(), ContentLevel::kLast);
  chooser.line().share_B_per_s.reset();
  chooser.during(1800ms);
  EXPECT_EQ(chooser.level(), ContentLevel::kLast);
  chooser.during(600ms);
  EXPECT_EQ(chooser.level(), 0U);
}

TEST(ContentLevel, AThinLineWithoutOtherFlowsGetsSmallerImagesToo) {
  Chooser chooser({.demand_B_per_s = 3e6, .dropped = 0.3});
  chooser.during(400ms);
  EXPECT_EQ(chooser.level(), 1U);
  chooser.line().dropped = 0.0;
  chooser.during(1800ms);
  EXPECT_EQ(chooser.level(), 1U);
}

TEST(ContentLevel, LargerImagesThatDoNotFitAreTriedLessAndLessOften) {
  Chooser chooser({.demand_B_per_s = 3e6, .dropped = 0.3});
  chooser.during(400ms);
  std::vector<Nanoseconds> waits;
  for (int i = 0; i < 5; ++i) {
    chooser.line().dropped = 0.0;
    Nanoseconds wait{0};
    for (; chooser.level() == 1 && wait < 60s; wait += 200ms) chooser.during(200ms);
    waits.push_back(wait);
    chooser.line().dropped = 0.3;
    chooser.during(400ms);
    ASSERT_EQ(chooser.level(), 1U);
  }
  for (std::size_t i = 1; i < waits.size(); ++i) EXPECT_GE(waits[i], std::min<Nanoseconds>(waits[i - 1] * 3 / 2, 16s));
  EXPECT_LE(waits.back(), 17s);
}

TEST(ContentLevel, OneOfFourImagesIsLeftOutAtTheLastLevelOnly) {
  for (std::size_t level = 0; level <= ContentLevel::kLast; ++level) {
    int out = 0;
    for (std::uint64_t number = 0; number < 100; ++number) out += ContentLevel::leaves_out(level, number) ? 1 : 0;
    EXPECT_EQ(out, level == ContentLevel::kLast ? 25 : 0);
  }
}

TEST(DropShare, IsTheShareOfTheLastHalfSecond) {
  DropShare drops;
  EXPECT_EQ(drops.step(0, 0), 0.0);
  EXPECT_LT(drops.step(1, 1), 0.15) << "one image is no share";
  std::uint64_t offered = 1, dropped = 1;
  for (int i = 0; i < 10; ++i) (void)drops.step(offered += 6, dropped += 3);
  EXPECT_NEAR(drops.step(offered, dropped), 0.5, 0.1);
  for (int i = 0; i < 10; ++i) (void)drops.step(offered += 6, dropped);
  EXPECT_LT(drops.step(offered, dropped), 0.02);
}

}  // namespace
}  // namespace telepalp::link
