#include "tools/study/task/design.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tools/study/task/insertion.h"
#include "tools/study/task/tools.h"

namespace telepalp::study {
namespace {

TEST(Design, TheAmniocentesisDesignIsTheThirtySixMechanismsOfTheTable) {
  const Design design = amniocentesis_design();
  ASSERT_EQ(design.configurations.size(), 36U);
  EXPECT_EQ(design.configurations[0].name, "linkage 1, phi 0, h 0, l_h 140");
  EXPECT_EQ(design.configurations[11].name, "linkage 1, phi 5pi/6, h 80, l_h 180");
  EXPECT_DOUBLE_EQ(design.configurations[35].bar.l1_m, 0.12);
  EXPECT_DOUBLE_EQ(design.configurations[35].bar.handle_at_m, 0.08);
}

TEST(Design, AListGivesMillimetresAndRadians) {
  const Result<Design> design = parse_design(
      "# mine\nname=short l1=70 l2=140 l3=110 l4=120 theta=-0.3 phi=1.5 h=10 l_h=150\n\n l_h=200\n", "mine.txt");
  ASSERT_TRUE(design.ok()) << to_string(design.error());
  ASSERT_EQ(design->configurations.size(), 2U);
  EXPECT_EQ(design->configurations[0].name, "short");
  EXPECT_DOUBLE_EQ(design->configurations[0].bar.l4_m, 0.12);
  EXPECT_TRUE(design->configurations[0].l4_given);
  EXPECT_EQ(design->configurations[1].name, "line 4");
  EXPECT_DOUBLE_EQ(design->configurations[1].bar.handle_m, 0.2);
  EXPECT_FALSE(design->configurations[1].l4_given);
}

TEST(Design, AListTakesOtherKindsOfMechanisms) {
  const Result<Design> design = parse_design(
      "name=slider kind=slider-crank crank=60 rod=150 handle=140 at=2.2\nkind=five-bar left=110 needle=90\n"
      "kind=six-bar arm=45 l_h=150\nkind=four-bar l_h=150\n",
      "mine.txt");
  ASSERT_TRUE(design.ok()) << to_string(design.error());
  ASSERT_EQ(design->configurations.size(), 4U);
  const SliderCrankAt& slider = std::get<SliderCrankAt>(*design->configurations[0].other);
  EXPECT_DOUBLE_EQ(slider.crank.crank_m, 0.06);
  EXPECT_DOUBLE_EQ(slider.crank_rad, 2.2);
  EXPECT_FALSE(design->configurations[0].needle_given);
  EXPECT_DOUBLE_EQ(std::get<FiveBarAt>(*design->configurations[1].other).bar.left_m, 0.11);
  EXPECT_TRUE(design->configurations[1].needle_given);
  EXPECT_DOUBLE_EQ(std::get<SixBarAt>(*design->configurations[2].other).bar.bar.handle_m, 0.15);
  EXPECT_FALSE(design->configurations[3].other.has_value());
}

TEST(Design, OtherKindsAreHeldUprightOutsideTheSkinAndDoTheWorkOfTheirNeedle) {
  for (const char* const line : {"kind=slider-crank", "kind=five-bar", "kind=six-bar"}) {
    const Configuration one = parse_design(line, "one")->configurations.front();
    Result<std::unique_ptr<HeldTool>> made = linkage_tool(one, Plant{});
    ASSERT_TRUE(made.ok()) << line << ": " << to_string(made.error());
    HeldTool& tool = **made;
    EXPECT_NEAR(tool.tip_m().y(), kAbove_m, 2e-4) << line;
    const Eigen::Vector3d needle_N(0.3, 2.0, 0.0);
    double way_m = 0.0;
    double worst = 0.0;
    for (; tool.tip_m().y() > -Plant{}.sac_depth_m && way_m < 0.25; way_m += 2e-4) {
      tool.step(tool.on_the_way_m(way_m), kTick_s);
      const Eigen::Vector3d tip_m = tool.tip_m();
      const Eigen::Vector3d hand_N = tool.hand_force_N(needle_N);
      const double at_hand = hand_N.dot(tool.on_the_way_m(way_m + 1e-6) - tool.on_the_way_m(way_m));
      tool.step(tool.on_the_way_m(way_m + 1e-6), kTick_s);
      worst = std::max(worst, std::abs(needle_N.dot(tool.tip_m() - tip_m) - at_hand) / (needle_N.norm() * 1e-6));
    }
    EXPECT_LT(worst, 1e-3) << line;
    EXPECT_NEAR(tool.axis().y(), -1.0, 1e-3) << line << ": upright at the sac";
    EXPECT_NEAR(tool.tip_m().x(), 0.0, 1e-3) << line;
    EXPECT_GE(tool.picture().count, 3U);
  }
}

struct BadList {
  const char* text;
  const char* error;
};
class BadLists : public ::testing::TestWithParam<BadList> {};
TEST_P(BadLists, AreRefusedWithLineColumnReasonAndFix) {
  const Result<Design> design = parse_design(GetParam().text, "mine.txt");
  ASSERT_FALSE(design.ok());
  EXPECT_EQ(to_string(design.error()).rfind(GetParam().error, 0), 0U) << to_string(design.error());
  EXPECT_FALSE(design.error().fix.empty());
}
INSTANTIATE_TEST_SUITE_P(
    All, BadLists,
    ::testing::Values(BadList{"l1=80\nl1=80 lenght=3",
                              "mine.txt:2:7: 'lenght' is no parameter of a mechanism. fix: give one of name, l1"},
                      BadList{"  l1=8o", "mine.txt:1:6: '8o' is not a number"},
                      BadList{"l1=nan", "mine.txt:1:1: l1 is not a finite number"},
                      BadList{"l1", "mine.txt:1:1: 'l1' is not a pair name=value"},
                      BadList{"l1=", "mine.txt:1:1: 'l1=' is not a pair"},
                      BadList{"l4=400", "mine.txt:1:1: links l1 = 80, l2 = 150, l3 = 120 and l4 = 400 mm cannot close"},
                      BadList{"name=a\nname=a", "mine.txt:2:1: the name 'a' is used twice"},
                      BadList{"l1=80 kind=five-bar", "mine.txt:1:12: kind comes after a parameter"},
                      BadList{"kind=pantograph", "mine.txt:1:6: 'pantograph' is no kind of mechanism"},
                      BadList{"kind=five-bar l1=80",
                              "mine.txt:1:15: 'l1' is no parameter of a mechanism. fix: give "
                              "one of name, base, left"},
                      BadList{"kind=slider-crank rod=0", "mine.txt:1:1: rod is 0 mm"},
                      BadList{"kind=slider-crank rod=nan", "mine.txt:1:1: rod is nan mm"},
                      BadList{"kind=slider-crank rod=10", "mine.txt:1:1: slider-crank: the joints"},
                      BadList{"kind=five-bar y=900", "mine.txt:1:1: five-bar: the joints"},
                      BadList{"kind=six-bar at=7", "mine.txt:1:1: at is 7 rad"},
                      BadList{"# nothing\n", "mine.txt: the list has 0 mechanisms"}));

}  // namespace
}  // namespace telepalp::study
