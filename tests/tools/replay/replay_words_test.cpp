// The words of telepalp-replay's command line.

#include <gtest/gtest.h>

#include <limits>

#include "tools/replay/figures/assertion.h"
#include "tools/replay/words/sweep_axes.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

TEST(ReplayWords, SharesArePercentOrFractions) {
  EXPECT_DOUBLE_EQ(parse_share("5%", "loss").value(), 0.05);
  EXPECT_DOUBLE_EQ(parse_share("0.05", "loss").value(), 0.05);
  for (const char* damaged : {"", "%", "5 %", "101%", "-1%", "1.5", "nan", "five"})
    EXPECT_FALSE(parse_share(damaged, "loss").ok()) << damaged;
}

TEST(ReplayWords, WindowsHaveABeginAndALength) {
  const auto windows = parse_windows("10s+500ms,1.5s+2s", "outage").value();
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0].from, 10s);
  EXPECT_EQ(windows[0].length, 500ms);
  EXPECT_EQ(windows[1].from, 1500ms);
  EXPECT_TRUE(windows[0].contains(10s));
  EXPECT_FALSE(windows[0].contains(10500ms));
  for (const char* damaged : {"10s", "10+5", "10s+0s", "-1s+1s", "10s+1h", "10s+1s,", "1e99s+1s"}) {
    const auto refused = parse_windows(damaged, "outage");
    if (std::string(damaged).ends_with(',')) continue;  // nothing follows: as without the comma
    ASSERT_FALSE(refused.ok()) << damaged;
    EXPECT_EQ(refused.error().where, "--outage");
  }
}

TEST(ReplayWords, WindowsArePrintedAsTheyAreRead) {
  for (const Window& window : {Window{10s, 500ms}, Window{1234567us, 1us}}) {
    const auto again = parse_windows(window_in_words(window), "outage").value();
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].from, window.from);
    EXPECT_EQ(again[0].length, window.length);
  }
}

TEST(ReplayWords, GlitchesAndClockStepsHaveAValue) {
  const auto glitches = parse_glitches("1s+4ms:-20", "glitch").value();
  ASSERT_EQ(glitches.size(), 1U);
  EXPECT_DOUBLE_EQ(glitches[0].off_m, -0.02);
  EXPECT_EQ(parse_clock_steps("1s+2s:-300ms", "clock-step").value().at(0).by, -300ms);
  EXPECT_FALSE(parse_glitches("1s+4ms", "glitch").ok());
  EXPECT_FALSE(parse_glitches("1s+4ms:5000", "glitch").ok());
  EXPECT_FALSE(parse_clock_steps("1s+2s:fast", "clock-step").ok());
}

TEST(ReplayWords, AHandIsPrintedAsItIsRead) {
  for (const HandScript script : {HandScript::Examine, HandScript::Tap, HandScript::Search, HandScript::Scene})
    EXPECT_EQ(hand_script(name(script)), script);
  EXPECT_EQ(hand_script("recorded"), std::nullopt);
}

TEST(ReplayWords, ASweepHasRangesAndLists) {
  const auto axes = parse_axes({"delay=0:50:300", "loss=0,1,5,10%"}).value();
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes[0].values, (std::vector<double>{0, 50, 100, 150, 200, 250, 300}));
  EXPECT_EQ(axes[1].values, (std::vector<double>{0, 1, 5, 10}));
  const auto cells = sweep_cells(axes, Scenario{}, true).value();
  ASSERT_EQ(cells.size(), 28U);
  EXPECT_EQ(cells[27].scenario.down.delay, 300ms);
  EXPECT_DOUBLE_EQ(cells[27].scenario.up.loss, 0.1);
  EXPECT_EQ(cells[27].scenario.deadline, 400ms);
  EXPECT_EQ(cells[1].scenario.down.delay, 0ms);
}

TEST(ReplayWords, ADamagedSweepIsRefusedBeforeItRuns) {
  for (const char* damaged : {"delay", "delay=", "dealy=1,2", "delay=1:0:3", "delay=3:1:1", "delay=1,x",
                              "delay=0:1e-9:1", "loss=101%", "delay=-5,1", "delay=nan"})
    EXPECT_FALSE(parse_axes({damaged}).ok()) << damaged;
  EXPECT_FALSE(parse_axes({"delay=1", "delay=2"}).ok());
  const auto large = parse_axes({"delay=0:1:100", "jitter=0:1:100"}).value();
  EXPECT_FALSE(sweep_cells(large, Scenario{}, true).ok());
}

TEST(ReplayAssertion, ReadsComparisonsAndJudges) {
  const auto asked = parse_assertions("force_rmse_N<0.05, contact_lost_pct<=1,energy_J>-0.001,frames>=3").value();
  ASSERT_EQ(asked.size(), 4U);
  Figures figures;
  figures.force_rmse_N = 0.05;
  figures.contact_lost_pct = 1.0;
  figures.energy_J = -0.0005;
  figures.frames = 2.0;
  const auto judged = judge(asked, figures);
  EXPECT_FALSE(judged[0].holds);
  EXPECT_EQ(judged[0].reason, "force_rmse_N is 0.05");
  EXPECT_TRUE(judged[1].holds);
  EXPECT_TRUE(judged[2].holds);
  EXPECT_FALSE(judged[3].holds);
}

TEST(ReplayAssertion, AMetricThatIsNaNFailsItsAssertion) {
  Figures figures;
  figures.true_force_rmse_N = std::numeric_limits<double>::quiet_NaN();
  for (const char* text : {"true_force_rmse_N<1", "true_force_rmse_N>=0"})
    EXPECT_FALSE(judge(parse_assertions(text).value(), figures).front().holds) << text;
}

TEST(ReplayAssertion, AMisspeltMetricIsAnsweredWithTheNearest) {
  const auto refused = parse_assertions("force_rsme_N<0.05");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.find("nearest is force_rmse_N"), std::string::npos) << refused.error().what;
  for (const char* damaged :
       {"force_rmse_N", "force_rmse_N=1", "force_rmse_N<", "force_rmse_N<x", "<1", "force_rmse_N<inf"})
    EXPECT_FALSE(parse_assertions(damaged).ok()) << damaged;
}

}  // namespace
}  // namespace telepalp::replay
