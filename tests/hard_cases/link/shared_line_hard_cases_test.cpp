// A session beside downloads, in virtual time: the link's own classes at both ends of a tail-drop bottleneck.
#include <algorithm>

#include "tests/bench/link/beside_run.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace std::chrono_literals;
using bench::link::BesideOutcome;
using bench::link::BesideScenario;
using bench::link::Rival;
using bench::link::RivalKind;
using testing::AssertionResult;

constexpr double kFairOfTwo = 0.5;
constexpr double kCamera_B_per_s = 94e3 * 30.0;  ///< what the camera sends; a fair share is never more
constexpr double kPartOfFair = 0.3;
constexpr double kMostAboveQueue_ms = 60.0;

/// A line of `mbit` Mbit/s with `buffer` of queue and a round trip of 5 ms, and `rivals` on it, for 40 s.
BesideScenario line(double mbit, Nanoseconds buffer, std::vector<Rival> rivals) {
  const double rate_B_per_s = mbit * 125'000.0;
  return {.down = {.delay = 2500us,
                   .rate_B_per_s = rate_B_per_s,
                   .queue_B = static_cast<std::size_t>(rate_B_per_s * to_seconds(buffer))},
          .back = 2500us,
          .rivals = std::move(rivals),
          .seconds = 40.0,
          .measured_until_s = 40.0};
}

Claim images(const BesideOutcome& outcome) {
  return figure("images a second", outcome.images_per_s >= 20.0, outcome.images_per_s, 1.0, "");
}
Claim prompt(const BesideOutcome& outcome) {
  const double p95_ms = outcome.above_queue_ms.quantile(0.95);
  return figure("capture to image above the queue's delay, p95", p95_ms <= kMostAboveQueue_ms, p95_ms, 1.0, "ms");
}
Claim never_gone(const BesideOutcome& outcome) {
  return below("longest time without an image", to_seconds(outcome.longest_gap), 0.5, 1e3, "ms");
}
Claim share(const char* whose, double share, double fair = kFairOfTwo) {
  return figure(whose, share >= kPartOfFair * fair, share, 100.0, "% of the line");
}

AssertionResult holds_beside(double mbit, Nanoseconds buffer, RivalKind kind) {
  const BesideScenario scenario = line(mbit, buffer, {{kind, 2s}});
  const BesideOutcome outcome = bench::link::run_beside(scenario).front();
  const double ours = std::min(kFairOfTwo, kCamera_B_per_s / scenario.down.rate_B_per_s);
  return all_of({images(outcome), prompt(outcome), never_gone(outcome), share("ours", outcome.share, ours),
                 share("theirs", outcome.rivals_share, 1.0 - ours)});
}

AssertionResult cubic_thin_short() { return holds_beside(40.0, 30ms, RivalKind::Cubic); }
AssertionResult cubic_thin_deep() { return holds_beside(40.0, 200ms, RivalKind::Cubic); }
AssertionResult cubic_wide_short() { return holds_beside(100.0, 30ms, RivalKind::Cubic); }
AssertionResult cubic_wide_deep() { return holds_beside(100.0, 200ms, RivalKind::Cubic); }
AssertionResult reno_deep() { return holds_beside(40.0, 200ms, RivalKind::Reno); }
AssertionResult bbr_deep() { return holds_beside(40.0, 200ms, RivalKind::Bbr); }

/// The download ends at 15 s; measured from 5 s later.
AssertionResult alone_again() {
  BesideScenario scenario = line(40.0, 200ms, {{RivalKind::Cubic, 2s, 15s}});
  scenario.measured_from_s = 20.0;
  scenario.seconds = scenario.measured_until_s = 30.0;
  const BesideOutcome outcome = bench::link::run_beside(scenario).front();
  const double standing_ms = outcome.queue_ms.p50();
  return all_of({figure("images a second", outcome.images_per_s > 29.0, outcome.images_per_s, 1.0, ""),
                 figure("queue, p50", standing_ms <= 20.0, standing_ms, 1.0, "ms"),
                 figure("beside others", outcome.beside == 0.0, outcome.beside, 100.0, "% of the time")});
}

AssertionResult two_sessions() {
  BesideScenario scenario = line(40.0, 200ms, {});
  scenario.sessions = 2;
  const std::vector<BesideOutcome> both = bench::link::run_beside(scenario);
  return all_of({images(both.front()), images(both.back()), share("the first one's", both.front().share),
                 share("the second one's", both.back().share)});
}

/// A camera with noise, whose depth stays large at each level.
AssertionResult noisy_camera(Nanoseconds buffer) {
  BesideScenario scenario = line(40.0, buffer, {{RivalKind::Cubic, 2s}});
  scenario.image_B = {123'000, 98'000, 91'000};
  const BesideOutcome outcome = bench::link::run_beside(scenario).front();
  return all_of({images(outcome), prompt(outcome), never_gone(outcome), share("ours", outcome.share),
                 share("theirs", outcome.rivals_share)});
}
AssertionResult noisy_short() { return noisy_camera(30ms); }
AssertionResult noisy_deep() { return noisy_camera(200ms); }

AssertionResult two_sessions_short() {
  BesideScenario scenario = line(40.0, 30ms, {});
  scenario.sessions = 2;
  const std::vector<BesideOutcome> both = bench::link::run_beside(scenario);
  return all_of({images(both.front()), images(both.back()), prompt(both.front()), prompt(both.back())});
}

/// A line that carries less than the camera sends, with nothing else on it.
AssertionResult alone_on_a_thin_line() {
  const BesideOutcome outcome = bench::link::run_beside(line(16.0, 200ms, {})).front();
  return all_of({figure("beside others", outcome.beside < 0.05, outcome.beside, 100.0, "% of the time"),
                 below("queue, p95", 1e-3 * outcome.queue_ms.quantile(0.95), 0.05, 1e3, "ms")});
}

/// The line falls from 20 to 2 Mbit/s, with a buffer of 500 ms of the thin line.
AssertionResult falls_to_a_tenth() {
  const auto row = [](Nanoseconds at, double mbit) {
    return impaired::TraceRow{.at = at, .delay = 25ms, .rate_B_per_s = mbit * 125'000.0};
  };
  BesideScenario scenario{.down = {.delay = 25ms, .rate_B_per_s = 20 * 125'000.0, .queue_B = 125'000},
                          .back = 25ms,
                          .seconds = 20.0,
                          .measured_from_s = 8.0,
                          .measured_until_s = 20.0,
                          .image_B = {40'000},
                          .trace = {row(0s, 20.0), row(8s, 2.0), row(60s, 2.0)},
                          .planned = true};
  const BesideOutcome outcome = bench::link::run_beside(scenario).front();
  return all_of({below("age of an image, p95", 1e-3 * outcome.age_ms.quantile(0.95), 0.25, 1e3, "ms"),
                 figure("images a second", outcome.images_per_s >= 15.0, outcome.images_per_s, 1.0, ""),
                 below("longest time without an image", to_seconds(outcome.longest_gap), 1.0, 1e3, "ms"),
                 figure("beside others", outcome.beside < 0.05, outcome.beside, 100.0, "% of the time")});
}

const HardCase kRows[] = {
    {"falls from 20 to 2 Mbit/s", "the queue holds what was sent for the wide line", "empty it before it sends more",
     falls_to_a_tenth},
    {"Cubic, 40 Mbit/s, buffer of 30 ms", "a sender that keeps to a short queue starves", "hold its ground",
     cubic_thin_short},
    {"Cubic, 40 Mbit/s, buffer of 200 ms", "each round trip is 40 times longer", "hold its ground", cubic_thin_deep},
    {"Cubic, 100 Mbit/s, buffer of 30 ms", "the camera needs a quarter of the line", "hold its ground",
     cubic_wide_short},
    {"Cubic, 100 Mbit/s, buffer of 200 ms", "the queue holds 2.5 MB of the other flow", "hold its ground",
     cubic_wide_deep},
    {"Reno, 40 Mbit/s, buffer of 200 ms", "its window is halved at a loss", "leave it its part", reno_deep},
    {"BBR, 40 Mbit/s, buffer of 200 ms", "it heeds no loss", "hold its ground", bbr_deep},
    {"the download ends", "the window is that of a full queue", "empty the queue within 5 s", alone_again},
    {"two sessions, 40 Mbit/s", "each sees the other's queue", "both show images", two_sessions},
    {"two sessions, 40 Mbit/s, buffer of 30 ms", "each session's images and repairs overflow the buffer",
     "both show images in time", two_sessions_short},
    {"images of 123 kB, buffer of 200 ms", "even the smallest images take more than half of the line",
     "leave images out", noisy_deep},
    {"images of 123 kB, buffer of 30 ms", "an image does not fit into the buffer", "spread the image over time",
     noisy_short},
    {"alone on 16 Mbit/s", "the queue is its own", "not take it for another's, and keep it short",
     alone_on_a_thin_line},
};

class SharedLineHardCases : public HardCaseTable {};
TEST_P(SharedLineHardCases, Holds) { judge(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Table, SharedLineHardCases, testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
