#include "tools/replay/commands/storm_command.h"

#include <algorithm>
#include <cstdio>
#include <mutex>

#include "support/program/parallel.h"
#include "tools/replay/commands/progress_bar.h"
#include "tools/replay/commands/run_command.h"
#include "tools/replay/storm/storm.h"
#include "tools/replay/words/say.h"

namespace telepalp::replay {
namespace {

/// The results of a storm, written by its threads.
class Findings {
 public:
  explicit Findings(int seeds) : bar_(seeds) {}

  void add(std::uint64_t seed, const Result<StormOutcome>& outcome) {
    const std::lock_guard lock(mutex_);
    if (!outcome)
      error_ = outcome.error();
    else if (outcome->violation)
      fail(seed, *outcome->violation);
    if (outcome) sum_up(seed, *outcome);
    bar_.show(++done_, "seeds");
  }
  [[nodiscard]] const std::vector<std::uint64_t>& failed() const noexcept { return failed_; }
  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }
  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  void print_ledgers() const {
    const auto print = [](const char* what, const std::pair<double, std::uint64_t>& worst) {
      std::printf("%s: %.1f mJ", what, 1e3 * worst.first);
      if (worst.first != 0.0) std::printf(" (seed %llu)", static_cast<unsigned long long>(worst.second));
      std::printf("\n");
    };
    print(
        "lowest energy balance of the display (energy taken from the hand less energy stored; below 0: the display "
        "created energy)",
        least_passivity_J_);
    print(
        "largest excess work on the hand in one contact (the device's work, minus the work of the newest "
        "measured skin on the same path)",
        most_excess_J_);
    print(
        "most energy that a hand gained in one contact (the smaller of the device's work on the hand and the excess "
        "work)",
        most_gained_J_);
    std::printf(
        "longest time in a contact with less than half of the true skin's force (above 0.2 N; images younger than 0.5 "
        "s): %.2f s (seed %llu)\n",
        longest_weak_s_.first, static_cast<unsigned long long>(longest_weak_s_.second));
  }

 private:
  void sum_up(std::uint64_t seed, const StormOutcome& outcome) {
    seconds_ += outcome.seconds;
    if (outcome.ledgers.least_passivity_J < least_passivity_J_.first)
      least_passivity_J_ = {outcome.ledgers.least_passivity_J, seed};
    if (outcome.ledgers.most_excess_J > most_excess_J_.first) most_excess_J_ = {outcome.ledgers.most_excess_J, seed};
    if (outcome.ledgers.longest_weak_s > longest_weak_s_.first)
      longest_weak_s_ = {outcome.ledgers.longest_weak_s, seed};
    if (outcome.ledgers.most_gained_J > most_gained_J_.first) most_gained_J_ = {outcome.ledgers.most_gained_J, seed};
  }
  void fail(std::uint64_t seed, const Invariants::Violation& violation) {
    failed_.push_back(seed);
    say("seed " + std::to_string(seed) + " fails a check " + in_words(violation) +
        ". To repeat this run: telepalp-replay " + command_line(draw_case(seed)));
  }

  std::mutex mutex_;
  ProgressBar bar_;
  int done_ = 0;
  double seconds_ = 0.0;
  std::pair<double, std::uint64_t> least_passivity_J_{};  // with its seed
  std::pair<double, std::uint64_t> most_excess_J_{};
  std::pair<double, std::uint64_t> most_gained_J_{};
  std::pair<double, std::uint64_t> longest_weak_s_{};
  std::vector<std::uint64_t> failed_;
  std::optional<Error> error_;
};

Result<void> print_shrunk(std::uint64_t seed) {
  const Result<StormCase> simplest = shrunk(draw_case(seed));
  if (!simplest) return simplest.error();
  const Result<StormOutcome> outcome = run_case(*simplest);
  if (!outcome) return outcome.error();
  std::printf(
      "seed %llu, reduced to a simpler run, which %s\n  telepalp-replay %s\n", static_cast<unsigned long long>(seed),
      outcome->violation ? ("fails a check " + in_words(*outcome->violation)).c_str() : "passes when it runs again",
      command_line(*simplest).c_str());
  std::fflush(stdout);  // the next seed takes a while to shrink
  return {};
}

}  // namespace

Result<bool> run_storm(const Request& request) {
  const int seeds = *request.storm_seeds;
  const std::int64_t began_ns = steady_ns();
  Findings findings(seeds);
  program::for_each_parallel(seeds, request.threads, [&](int i) {
    const std::uint64_t seed = request.scenario.seed + static_cast<std::uint64_t>(i);
    findings.add(seed, run_case(draw_case(seed)));
  });
  if (findings.error()) return *findings.error();
  std::vector<std::uint64_t> failed = findings.failed();
  std::sort(failed.begin(), failed.end());
  for (const std::uint64_t seed : failed)
    if (const Result<void> printed = print_shrunk(seed); !printed) return printed.error();
  std::printf("random runs: %d; runs in which a check failed: %zu; virtual time in all: %.0f s\n", seeds, failed.size(),
              findings.seconds());
  findings.print_ledgers();
  const double wall_s = 1e-9 * static_cast<double>(steady_ns() - began_ns);
  char text[64];
  std::snprintf(text, sizeof text, "the random runs ran %.1f times as fast as real time", findings.seconds() / wall_s);
  say(text);
  return failed.empty();
}

}  // namespace telepalp::replay
