#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

#include "tests/bench/accuracy/accuracy_page.h"
#include "tests/bench/accuracy/accuracy_pareto.h"
#include "where.h"

namespace telepalp::bench {
namespace {

TEST(Pareto, TheFrontContainsTheTradeoffsThatNoneBeatsInBoth) {
  const Tradeoff all[] = {{3.0, 1.0}, {1.0, 3.0}, {2.0, 2.0}, {2.5, 2.5}, {2.0, 4.0}, {3.0, 1.0}};
  EXPECT_EQ(pareto_front(all), (std::vector<std::size_t>{0, 2, 1}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Pareto, AValueThatIsNotFiniteIsOnNoFront) {
  const Tradeoff all[] = {{std::nan(""), 1.0}, {1.0, 2.0}};
  EXPECT_EQ(pareto_front(all), std::vector<std::size_t>{1});
  EXPECT_EQ(knee_of(all), 1U);
}

TEST(Pareto, TheKneeIsTheLeastProductOfThoseAllowed) {
  const Tradeoff all[] = {{4.0, 1.0}, {1.0, 1.5, false}, {1.5, 2.0}, {1.0, 6.0}};
  EXPECT_EQ(knee_of(all), 2U);
  const Tradeoff none[] = {{1.0, 1.0, false}};
  EXPECT_EQ(knee_of(none), 1U);
}

TEST(Page, TheTextStaysAndTheMeasuredPartsAreRewritten) {
  const std::string page = "by hand\n<!-- begin a -->\nold\n<!-- end a -->\nalso\n<!-- begin b -->\n<!-- end b -->\n";
  const auto once = with_parts(page, {{"a", "1\n"}, {"b", "2\n"}}, "page.md");
  ASSERT_TRUE(once.ok());
  EXPECT_EQ(*once, "by hand\n<!-- begin a -->\n1\n<!-- end a -->\nalso\n<!-- begin b -->\n2\n<!-- end b -->\n");
  EXPECT_EQ(*with_parts(*once, {{"a", "1\n"}, {"b", "2\n"}}, "page.md"), *once);
}

TEST(Page, AMissingMarkerIsNamed) {
  const auto made = with_parts("<!-- begin a -->\n", {{"a", "1"}}, "page.md");
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().what.find("<!-- end a -->"), std::string::npos);
}

TEST(Page, ThePageThatShipsHasEveryMarker) {
  std::ifstream in(TELEPALP_SOURCE_DIR "/docs/accuracy.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (const char* part : {"measured-surface",
                           "measured-slopes",
                           "surface",
                           "knee",
                           "slopes",
                           "noise",
                           "density",
                           "patients",
                           "time",
                           "hand",
                           "organ",
                           "proxy",
                           "trees",
                           "tips",
                           "scenes",
                           "price",
                           "jpeg",
                           "camera",
                           "levels",
                           "anchors",
                           "marks",
                           "ultrasound",
                           "viewer",
                           "z-width",
                           "modes",
                           "bounded",
                           "nets",
                           "needle-steps",
                           "prism-meshes",
                           "prism-rates",
                           "contact",
                           "measured-needle",
                           "measured-price",
                           "measured-depth",
                           "measured-organ",
                           "measured-solids",
                           "measured-patients",
                           "measured-settings",
                           "measured-z-width",
                           "measured-prediction"}) {
    const auto made = with_parts(page, {{part, "x\n"}}, "accuracy.md");
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  }
}

TEST(Page, ItsCommitsExist) {
  if (!std::filesystem::exists(TELEPALP_SOURCE_DIR "/.git")) GTEST_SKIP() << "not a checkout";
  std::ifstream in(TELEPALP_SOURCE_DIR "/docs/accuracy.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::regex words(", at commit ([0-9a-f]{7,40})");
  int commits = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), words), end; at != end; ++at, ++commits) {
    const std::string known = "git -C " TELEPALP_SOURCE_DIR " cat-file -e " + (*at)[1].str() + "^{commit} 2>&1";
    EXPECT_EQ(std::system(known.c_str()), 0) << (*at)[0] << " is in no history";
  }
  EXPECT_GT(commits, 0) << "the page names no commit";
}

}  // namespace
}  // namespace telepalp::bench
