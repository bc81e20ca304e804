// Camera frames over the paths that are hardest for the sealed datagrams, in virtual time.
#include "proto/impaired/profiles.h"
#include "proto/link/path/loss_meter.h"
#include "proto/link/path/path_estimate.h"
#include "tests/bench/link/link_scenario.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {
namespace {

using namespace std::chrono_literals;
using bench::link::Outcome;
using bench::link::Scenario;
using testing::AssertionResult;

/// A symmetric path for 20 s.
Outcome over(const impaired::Impairment& either_way) {
  return bench::link::run_telepalp({.down = either_way, .up = either_way, .seconds = 20.0});
}

Claim at_least(const char* what, double share, double limit) { return figure(what, share >= limit, share, 100.0, "%"); }
Claim at_most(const char* what, double share, double limit) { return figure(what, share <= limit, share, 100.0, "%"); }
Claim shown(const Outcome& outcome, double limit) {
  return at_least("depth images shown", static_cast<double>(outcome.shown) / static_cast<double>(outcome.frames),
                  limit);
}
Claim overhead(const Outcome& outcome, double limit) {
  return at_most("overhead", 1e-2 * outcome.overhead_percent(), limit);
}
Claim nothing_wrong(const Outcome& outcome) {
  return figure("images with wrong bytes", outcome.wrong == 0, static_cast<double>(outcome.wrong), 1.0, "");
}

AssertionResult long_path_with_jitter() {
  const Outcome outcome = over({.delay = 300ms, .jitter = 30ms});
  return all_of({shown(outcome, 0.9), overhead(outcome, 0.1), nothing_wrong(outcome)});
}

AssertionResult long_lossy_path_with_jitter() {
  const Outcome outcome = over({.delay = 150ms, .jitter = 30ms, .loss = 0.05});
  return all_of({shown(outcome, 0.97), overhead(outcome, 0.35), nothing_wrong(outcome)});
}

AssertionResult jitter_wider_than_a_frame_period() {
  const Outcome outcome = over({.delay = 50ms, .jitter = 40ms, .loss = 0.01});
  return all_of({shown(outcome, 0.97), overhead(outcome, 0.45), nothing_wrong(outcome)});
}

AssertionResult deep_buffer_and_jitter() {
  const impaired::Impairment down{.delay = 50ms, .jitter = 20ms, .rate_B_per_s = 2e6, .queue_B = 2U << 20U};
  const Outcome outcome =
      bench::link::run_telepalp({.down = down, .up = {.delay = 50ms, .jitter = 20ms}, .seconds = 20.0});
  return all_of({below("age of the newest depth, p95", 1e-3 * outcome.depth_age_ms.quantile(0.95), 0.350, 1e3, "ms"),
                 nothing_wrong(outcome)});
}

/// 8.5 s of images after an outage, and 8.7 s before it.
AssertionResult outage_on_a_long_path() {
  const impaired::Impairment either_way{
      .delay = 180ms, .jitter = 40ms, .loss = 0.02, .outage_every = 10s, .outage_for = 1250ms};
  const Outcome outcome =
      bench::link::run_telepalp({.down = either_way, .up = either_way, .seconds = 18.5, .deadline = 280ms});
  return all_of({shown(outcome, 0.8),
                 below("age of the newest depth, p95", 1e-3 * outcome.depth_age_ms.quantile(0.95), 3.0, 1.0, "s"),
                 nothing_wrong(outcome)});
}

/// One report for each packet; the peer's clock is corrected by 20 ms halfway.
AssertionResult corrected_clock() {
  link::PathEstimate path;
  Nanoseconds longest{0};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const SessionTime sent{1s + i * 5ms};
    path.sent(i, 1200, sent);
    const Nanoseconds clock_error = i < 1000 ? 0ms : 20ms;
    path.on_feedback({.highest_sequence = i,
                      .received_bytes = 1200 * (i + 1),
                      .reported_ns = to_nanoseconds(sent + 2ms + clock_error)},
                     sent + 4ms);
    longest = std::max(longest, path.queue_delay());
  }
  return all_of({below("queue", to_seconds(longest), 1e-3, 1e3, "ms")});
}

AssertionResult overtaking_packets() {
  link::LossMeter meter;
  for (std::uint64_t i = 0; i < 20'000; ++i)  // 4 packets a millisecond; each fourth comes 400 packets late
    if (i % 4 != 0 || i >= 400) meter.received(i % 4 != 0 ? i : i - 400, SessionTime{1s + i * 250us});
  return all_of({figure("packets counted as lost", meter.lost() == 0, meter.lost(), 1.0, ""),
                 figure("packets counted", meter.settled() > 18'000, meter.settled(), 1.0, "")});
}

const HardCase kRows[] = {
    {"RTT 600 ms, jitter 30 ms", "jitter looks like a queue, and reports are late",
     "show the images, without a pause of the sender", long_path_with_jitter},
    {"RTT 300 ms, jitter 30 ms, 5 % lost", "no request is answered in time", "repair by spare datagrams alone",
     long_lossy_path_with_jitter},
    {"jitter 40 ms, frames each 33 ms", "packets of a frame come after the next frame", "not take them for lost",
     jitter_wider_than_a_frame_period},
    {"2 MB/s, 2 MiB of buffer, jitter 20 ms", "the queue hides in the jitter", "find the queue, and keep it short",
     deep_buffer_and_jitter},
    {"RTT 360 ms, nothing arrives for 1.25 s", "after silence, the sender begins with 19 kB in flight and needs 1.3 MB",
     "send whole images again within seconds", outage_on_a_long_path},
    {"the peer's clock jumps by 20 ms", "each packet seems to take 20 ms longer", "see no queue", corrected_clock},
    {"each fourth packet is overtaken by 300", "more than the packets that a meter waits for", "count no loss",
     overtaking_packets},
};

class LinkHardCases : public HardCaseTable {};
TEST_P(LinkHardCases, Holds) { judge(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Table, LinkHardCases, testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
