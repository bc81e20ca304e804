#include "tools/study/task/design.h"

#include <gtest/gtest.h>

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
                      BadList{"# nothing\n", "mine.txt: the list has 0 mechanisms"}));

}  // namespace
}  // namespace telepalp::study
