// Runs of a source in memory, compared with runs that read the source again.

#include <gtest/gtest.h>

#include "haptic_station/scenes/scene.h"
#include "tools/replay/figures/metrics.h"
#include "tools/replay/run/kept_session.h"

namespace {

using namespace telepalp;
using namespace telepalp::replay;
using namespace std::chrono_literals;

constexpr const char* kSource = "synthetic:torso,motion=irregular,width=160";
constexpr std::size_t kEnough_B = std::size_t{1} << 30U;

scenes::Scene scene() { return *scenes::read_scene(*scenes::find_scene("palpation")); }

Scenario bad_network(std::uint64_t seed) {
  Scenario scenario{.seed = seed};
  scenario.down.delay = scenario.up.delay = 60ms;
  scenario.down.loss = scenario.up.loss = 0.1;
  return scenario;
}

void expect_same(const RunResults& kept, const RunResults& anew) {
  ASSERT_EQ(kept.runs.size(), anew.runs.size());
  EXPECT_EQ(kept.seconds, anew.seconds);
  EXPECT_EQ(kept.images.frames, anew.images.frames);
  EXPECT_EQ(kept.images.depth.hex(), anew.images.depth.hex());
  for (std::size_t run = 0; run < kept.runs.size(); ++run)
    for (const Metric& metric : metrics()) {
      const double a = kept.runs[run].figures.*metric.value;
      const double b = anew.runs[run].figures.*metric.value;
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << metric.name << ": " << a << " and " << b;
    }
}

TEST(KeptSession, GivesTheFiguresOfARunFromTheBeginning) {
  for (const codec::DepthMode mode : {codec::DepthMode::Fast, codec::DepthMode::Temporal}) {
    TapeSettings tape;
    tape.depth.mode = mode;
    const scenes::Scene palpation = scene();
    const RunSettings settings{.scene = palpation, .surface = {}, .seconds = 1.7};
    const Result<std::optional<KeptSession>> kept =
        KeptSession::make(*Tape::open(kSource, tape), settings, Scenario{}, kEnough_B);
    ASSERT_TRUE(kept) << to_string(kept.error());
    ASSERT_TRUE(*kept);
    for (const std::uint64_t seed : {3U, 4U}) {
      Tape again = *Tape::open(kSource, tape);
      const Result<RunResults> anew =
          run_session(again, settings, {{.scenario = Scenario{}}, {.scenario = bad_network(seed)}});
      const Result<RunResults> run = (*kept)->run(bad_network(seed), nullptr);
      ASSERT_TRUE(anew) << to_string(anew.error());
      ASSERT_TRUE(run) << to_string(run.error());
      expect_same(*run, *anew);
      EXPECT_GT(run->runs[1].figures.datagrams_lost, 0.0);
    }
  }
}

TEST(KeptSession, IsNotMadeBeyondItsMemory) {
  const scenes::Scene palpation = scene();
  const RunSettings settings{.scene = palpation, .surface = {}, .seconds = 2.0};
  const auto kept = KeptSession::make(*Tape::open(kSource, {}), settings, Scenario{}, 500'000);
  ASSERT_TRUE(kept) << to_string(kept.error());
  EXPECT_FALSE(*kept);
}

TEST(KeptSession, EndsWhenItIsStopped) {
  const std::atomic<bool> stop{true};
  const scenes::Scene palpation = scene();
  const RunSettings settings{.scene = palpation, .surface = {}, .seconds = 2.0, .stop = &stop};
  EXPECT_FALSE(KeptSession::make(*Tape::open(kSource, {}), settings, Scenario{}, kEnough_B));
}

}  // namespace
