#include "tools/study/search/design_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/support/child_process.h"
#include "tests/tools/study/texts.h"
#include "tools/study/search/judgement_file.h"
#include "tools/study/search/search_page.h"
#include "where.h"

namespace telepalp::study {
namespace {

namespace fs = std::filesystem;

SearchSettings small(int threads = 1) {
  return {.operators = 2, .penetrations = 1, .held_out = 2, .seed = 1, .evaluations = 44, .threads = threads};
}

std::string refusal(const Result<void>& result) { return result ? "" : to_string(result.error()); }

TEST(SearchBox, OfThePaperHoldsTable1AndEachOfItsMechanisms) {
  const SearchBox box = paper_box();
  ASSERT_TRUE(checked(box).ok());
  EXPECT_EQ(box.ranges.size(), 7U);
  for (const Configuration& one : amniocentesis_design().configurations) {
    const std::optional<std::vector<double>> place = place_in(box, one);
    ASSERT_TRUE(place) << one.name;
    const Configuration back = mechanism_at(box, *place);
    for (const MechanismParameter& parameter : mechanism_parameters())
      EXPECT_NEAR(back.bar.*parameter.value, one.bar.*parameter.value, 1e-12) << one.name << " " << parameter.name;
    EXPECT_FALSE(back.l4_given);
  }
}

TEST(SearchBox, AMechanismOutsideOrWithAFixedParameterOfAnotherValueHasNoPlace) {
  SearchBox box = paper_box();
  ASSERT_TRUE(set_range(box, "h", "0", "--h").ok());
  int inside = 0;
  for (const Configuration& one : amniocentesis_design().configurations) inside += place_in(box, one) ? 1 : 0;
  EXPECT_EQ(inside, 18);
  ASSERT_TRUE(set_range(box, "l4", "100:130", "--l4").ok());
  EXPECT_FALSE(place_in(box, amniocentesis_design().configurations[0])) << "S4 does not give l4";
  EXPECT_TRUE(mechanism_at(box, std::vector<double>(7, 0.5)).l4_given);
}

TEST(SearchBox, WrongRangesAreRefusedWithThePlaceAndTheFix) {
  SearchBox box = paper_box();
  EXPECT_EQ(refusal(set_range(box, "l1", "120:80", "--l1")),
            "--l1: the least l1, 120, is above the most, 80. fix: give the smaller number first: 80:120");
  for (const char* text : {"nan:80", "80:inf", "-1:80", "0:1e9", "eighty", "80:", ":80", "", "80:90:100", "0x1:2"})
    EXPECT_NE(refusal(set_range(box, "l1", text, "--l1")).find("--l1: "), std::string::npos) << text;
  EXPECT_NE(refusal(set_range(box, "length", "1:2", "x")).find("'length' is no parameter"), std::string::npos);
  const auto parsed = parse_box(box, "# links\n\nl1=80:100\n  l2 = 150:nan\n", "box.txt");
  ASSERT_FALSE(parsed.ok());
  EXPECT_TRUE(to_string(parsed.error()).starts_with("box.txt:4:7: l2 = nan is out of bounds"))
      << to_string(parsed.error());
  const auto unknown = parse_box(box, "l1=80:100\n l9=1:2\n", "box.txt");
  ASSERT_FALSE(unknown.ok());
  EXPECT_TRUE(to_string(unknown.error()).starts_with("box.txt:2:2: 'l9' is no parameter"))
      << to_string(unknown.error());
  EXPECT_FALSE(parse_box(box, "l1=80:100\nl1=80:90\n", "box.txt").ok());
  EXPECT_FALSE(parse_box(box, "l1 80 100\n", "box.txt").ok());
}

TEST(SearchBox, ThatFixesAllIsRefused) {
  SearchBox box;
  ASSERT_TRUE(set_range(box, "l1", "80", "--l1").ok());
  EXPECT_FALSE(checked(box).ok());
  EXPECT_FALSE(search_designs(box, small(), nullptr).ok());
}

TEST(Panel, RefusesALinkageThatCannotCloseAndGivesItNoValue) {
  const Result<Panel> panel = Panel::of(1, 0, 2, 1);
  const Design stuck = *parse_design("name=stuck l1=80 l2=150 l3=120 l4=180\n", "list");
  const Judgement judgement = panel->judge(stuck.configurations[0], 1, 1);
  EXPECT_FALSE(judgement.feasible());
  EXPECT_FALSE(judgement.refused.empty());
  EXPECT_TRUE(judgement.overshoots_mm.empty());
}

TEST(Panel, AnOperatorWhoNeverPuncturedIsAFailureAndNotAZero) {
  Judgement judgement;
  judgement.failed = 3;
  judgement.never = 1;
  judgement.overshoots_mm = {4.0, std::nan(""), 6.0};
  judgement.hands_N = {1.0, std::nan(""), 3.0};
  summarise(judgement);
  EXPECT_FALSE(judgement.feasible());
  EXPECT_DOUBLE_EQ(judgement.overshoot_mm.mean, 5.0);
  EXPECT_DOUBLE_EQ(judgement.hand_N.mean, 2.0);
}

TEST(Panel, JudgesTwoMechanismsWithTheSameChanceAndAnyNumberOfThreadsGivesTheSame) {
  const Result<Panel> panel = Panel::of(1, 0, 3, 2);
  const Configuration one = amniocentesis_design().configurations[0];
  const Judgement alone = panel->judge(one, 2, 1);
  (void)panel->judge(amniocentesis_design().configurations[5], 2, 1);
  const Judgement again = panel->judge(one, 2, 2);
  ASSERT_TRUE(alone.feasible());
  EXPECT_EQ(alone.overshoots_mm, again.overshoots_mm);
  EXPECT_EQ(alone.hands_N, again.hands_N);
  EXPECT_GT(alone.hand_N.mean, 0.0);
}

struct Files {
  std::string json;
  std::string page;
  std::string rows;
};
Files run(const fs::path& out, int threads) {
  SearchSettings settings = small(threads);
  auto file = JudgementFile::open(out, settings);
  EXPECT_TRUE(file.ok());
  settings.store = file->get();
  const Result<SearchResult> result = search_designs(paper_box(), settings, nullptr);
  EXPECT_TRUE(result.ok());
  return {search_json(paper_box(), settings, *result), search_html(paper_box(), settings, *result),
          text_of(out / "evaluations.csv")};
}

TEST(DesignSearch, GivesTheSameBytesTwiceWithTwoThreadsAndWhenItIsResumed) {
  const support::TemporaryFolder one;
  const Files first = run(one.path(), 1);
  EXPECT_EQ(first.page.find("nan"), std::string::npos);
  const support::TemporaryFolder other;
  const Files second = run(other.path(), 2);
  EXPECT_EQ(second.json, first.json);
  EXPECT_EQ(second.page, first.page);
  EXPECT_EQ(second.rows, first.rows);
  // As if it had been killed within a row.
  std::ofstream(other.path() / "evaluations.csv", std::ios::trunc) << first.rows.substr(0, first.rows.size() * 2 / 3);
  const Files resumed = run(other.path(), 2);
  EXPECT_EQ(resumed.json, first.json);
  EXPECT_EQ(resumed.rows, first.rows);
}

TEST(DesignSearch, TheFrontIsJudgedAgainByOthersAndProgressCountsToTheEnd) {
  int last = 0;
  int again = 0;
  const Result<SearchResult> result = search_designs(paper_box(), small(), [&](const SearchState& state) {
    (state.held_out ? again : last) = state.done;
    EXPECT_LE(state.done, state.total);
  });
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->paper.size(), 36U);
  EXPECT_EQ(last, static_cast<int>(result->paper.size() + result->searched.size()));
  EXPECT_LE(last, 44);
  ASSERT_FALSE(result->front.empty());
  EXPECT_EQ(again, static_cast<int>(result->front.size()) + 2);
  for (const SearchedDesign& one : result->front) {
    ASSERT_TRUE(one.held_out);
    EXPECT_NE(one.held_out->overshoots_mm, one.searched.overshoots_mm) << "held-out operators are others";
  }
  EXPECT_LE(result->front.back().searched.overshoot_mm.mean, result->paper_best->searched.overshoot_mm.mean);
}

TEST(DesignSearch, AStopKeepsWhatIsDone) {
  std::stop_source stop;
  const Result<SearchResult> result = search_designs(
      paper_box(), small(),
      [&](const SearchState& state) {
        if (state.done == 5) stop.request_stop();
      },
      stop.get_token());
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->stopped);
  EXPECT_EQ(result->paper.size(), 5U);
  EXPECT_TRUE(result->searched.empty());
  EXPECT_FALSE(result->front.empty());
}

TEST(SearchProgram, RefusesAWrongBoxAndKeepsWhatIsDoneWhenItIsInterrupted) {
  const support::TemporaryFolder folder;
  const fs::path log = folder.path() / "log";
  const std::string out = (folder.path() / "out").string();
  const fs::path program = fs::path(TELEPALP_BINARY_DIR) / "bin" / "telepalp-study";
  support::ChildProcess wrong(program, {"search", "--l1", "120:80", "--out", out}, log);
  EXPECT_EQ(wrong.wait(std::chrono::seconds(20)), 2);
  EXPECT_NE(text_of(log).find("--l1: the least l1, 120, is above the most, 80"), std::string::npos) << text_of(log);
  EXPECT_FALSE(fs::exists(out));
  support::ChildProcess stopped(program, {"search", "--operators", "1", "--out", out}, log);
  const fs::path rows = fs::path(out) / "evaluations.csv";
  for (int i = 0; i < 600 && (!fs::exists(rows) || text_of(rows).find("\nsearch,") == std::string::npos); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  stopped.signal(SIGINT);
  EXPECT_NE(stopped.wait(std::chrono::seconds(20)), 0);
  EXPECT_NE(text_of(log).find("judged mechanisms are kept in"), std::string::npos) << text_of(log);
  EXPECT_NE(text_of(rows).find("\nsearch,"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::study
