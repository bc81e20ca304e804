#include "tools/study/run/study.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/child_process.h"
#include "tests/tools/study/texts.h"
#include "tools/study/page/files.h"
#include "tools/study/run/trial_row.h"
#include "where.h"

namespace telepalp::study {
namespace {

namespace fs = std::filesystem;

StudySettings small(const fs::path& out, int threads = 1) {
  StudySettings settings;
  settings.design = *parse_design("name=long l_h=180\nname=short l_h=60\n", "two");
  settings.operators = 2;
  settings.penetrations = 1;
  settings.threads = threads;
  settings.out = out;
  return settings;
}

std::string csv(const StudySettings& settings) {
  const Result<std::vector<Trial>> trials = run_study(settings, [](int) {});
  EXPECT_TRUE(trials.ok());
  return trials_csv(settings, *trials);
}

TEST(Study, GivesTheSameBytesTwiceWithAnyNumberOfThreadsAndWhenItIsResumed) {
  const support::TemporaryFolder one;
  const std::string first = csv(small(one.path()));
  EXPECT_EQ(kept_parts(parts_of(small(one.path()))), 8);
  fs::remove(one.path() / "runs" / "operator-002-both.csv");
  std::ofstream(one.path() / "runs" / "operator-001-force.csv", std::ios::trunc) << "# cut off";
  EXPECT_EQ(kept_parts(parts_of(small(one.path()))), 6);
  EXPECT_EQ(csv(small(one.path())), first);
  fs::remove_all(one.path() / "runs");
  EXPECT_EQ(csv(small(one.path(), 2)), first);
}

TEST(Study, FinishedPartsOfAnotherStudyAreNotTaken) {
  const support::TemporaryFolder folder;
  (void)csv(small(folder.path()));
  StudySettings other = small(folder.path());
  other.seed = 2;
  EXPECT_EQ(kept_parts(parts_of(other)), 0);
  other = small(folder.path());
  other.design.configurations[0].bar.handle_m = 0.181;
  EXPECT_EQ(kept_parts(parts_of(other)), 0);
}

TEST(Study, AMechanismThatCannotDrawItsNeedleOutIsRefusedBeforeAnythingRuns) {
  const support::TemporaryFolder folder;
  StudySettings settings = small(folder.path());
  settings.design = *parse_design("name=stuck l1=80 l2=150 l3=120 l4=180\n", "list");
  const Result<std::vector<Trial>> trials = run_study(settings, [](int) {});
  ASSERT_FALSE(trials.ok());
  EXPECT_NE(to_string(trials.error()).find("stuck"), std::string::npos) << to_string(trials.error());
  EXPECT_FALSE(fs::exists(folder.path() / "runs"));
}

TEST(Study, PageAndNumbersAreMadeForAListToo) {
  const support::TemporaryFolder folder;
  const StudySettings settings = small(folder.path());
  const Result<std::vector<Trial>> trials = run_study(settings, [](int) {});
  const Result<Check> check = check_operators(settings);
  const StudyResult result = *result_of(settings, *trials, *check);
  EXPECT_EQ(result_html(settings, result).find("nan"), std::string::npos);
  EXPECT_EQ(result_html(settings, result).find("Table 2</h2>"), std::string::npos) << "a list has no place in Table 2";
  EXPECT_NE(result_text(settings, result).find("long "), std::string::npos);
  EXPECT_NE(result_json(settings, result).find("\"mean_mm\""), std::string::npos);
}

TEST(Operators, AgreeWithGerovich2004ThatForceAndLiveSightHelp) {
  StudySettings settings;
  settings.operators = 12;
  const Result<Check> check = check_operators(settings);
  ASSERT_TRUE(check.ok());
  EXPECT_LT(check->force_m, 0.55 * check->neither_m) << "there: at least -52 %";
  EXPECT_LT(check->sees_layers_m, 0.2 * check->neither_m) << "there: at least -87 %";
}

/// Mean overshoot of ten penetrations by the same operator [m].
double overshoot_m(const Operator& person, const char* mechanism, Condition condition, const Plant& plant = {}) {
  const auto model = tissue::make_tissue(tissue_of(plant));
  const Design design = *parse_design(mechanism, "one");
  double sum_m = 0.0;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const auto tool = linkage_tool(design.configurations[0], plant);
    Learned learned{.depth_m = 0.04, .from = 5};
    device::Random random(i);
    const Outcome out = penetrate({**tool, *model, person, condition}, learned, random);
    EXPECT_TRUE(out.through);
    EXPECT_GE(out.deepest_m + 1e-12, out.overshoot_m);
    sum_m += 0.1 * out.overshoot_m;
  }
  return sum_m;
}

TEST(Operators, ALongerReactionOvershootsFurther) {
  Operator slow;
  slow.reaction_s = 0.6;
  EXPECT_GT(overshoot_m(slow, "l_h=140", Condition::Force), overshoot_m({}, "l_h=140", Condition::Force) + 0.002);
}

TEST(Operators, AForceTooSmallToBeNoticedDoesNotHelp) {
  Operator numb;
  numb.force_floor_N = 100.0;
  EXPECT_GT(overshoot_m(numb, "l_h=140", Condition::Force), overshoot_m({}, "l_h=140", Condition::Force) + 0.001);
}

TEST(Operators, AShortLeverLetsTheHandJumpFurtherEvenWithoutReflexes) {
  EXPECT_GT(overshoot_m({}, "l_h=70", Condition::NoReflexes), 1.5 * overshoot_m({}, "l_h=200", Condition::NoReflexes));
}

TEST(Operators, PunctureWithEveryKindOfMechanism) {
  for (const char* const line : {"kind=slider-crank", "kind=five-bar", "kind=six-bar"}) {
    const double m = overshoot_m({}, line, Condition::Both);
    EXPECT_GT(m, 0.001) << line;
    EXPECT_LT(m, 0.03) << line;
  }
}

TEST(StudyProgram, RefusesABadListWithItsPlaceAndACommandLineWithoutAFolder) {
  const support::TemporaryFolder folder;
  const fs::path list = folder.path() / "list.txt";
  const fs::path log = folder.path() / "log";
  std::ofstream(list) << "l1=80\nlength=3\n";
  const fs::path program = fs::path(TELEPALP_BINARY_DIR) / "bin" / "telepalp-study";
  support::ChildProcess bad(program, {"--design", list.string(), "--out", (folder.path() / "out").string()}, log);
  EXPECT_EQ(bad.wait(std::chrono::seconds(20)), 2);
  EXPECT_NE(text_of(log).find("list.txt:2:1: 'length' is no parameter of a mechanism"), std::string::npos)
      << text_of(log);
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
  support::ChildProcess nowhere(program, {}, log);
  EXPECT_EQ(nowhere.wait(std::chrono::seconds(20)), 2);
  EXPECT_NE(text_of(log).find("--out: no folder is named"), std::string::npos) << text_of(log);
}

}  // namespace
}  // namespace telepalp::study
