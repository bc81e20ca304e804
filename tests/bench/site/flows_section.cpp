#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include "tests/bench/choice.h"
#include "tests/bench/site/bulk_flow.h"
#include "tests/bench/site/flow_outcome.h"
#include "tests/bench/site/queue_watch.h"
#include "tests/bench/site/section.h"
#include "tests/bench/site/touch_session.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kSettles = 3s;  ///< after the first touchable image; not measured
constexpr Nanoseconds kAlone = 5s;
constexpr Nanoseconds kBeside = 20s;
constexpr Nanoseconds kAfter = 12s;
constexpr Nanoseconds kStandsFrom = 5s;  ///< after the other traffic's end
constexpr std::uint16_t kRivalPort = 9000;
constexpr std::uint64_t kPage_B = 2'000'000;

struct FlowRun {
  std::string name;
  SiteLine line;
  std::optional<BulkFlow::Kind> rival;  ///< nullopt: a second session of touch
  bool by_tcp = false;                  ///< UDP does not pass between the sites
};

struct Measured {
  std::string lacks;  ///< what the kernel lacks for the run; empty: nothing
  std::vector<FlowOutcome> sessions;
  double rival_B_per_s = 0.0;
  double standing_ms = 0.0;  ///< queueing delay, median, after the other traffic
};

const std::vector<SiteLine> kLines{{40.0, 30.0}, {40.0, 200.0}, {100.0, 30.0}, {100.0, 200.0}};

std::string name_of(const SiteLine& line, const std::string& rival) {
  char text[80];
  std::snprintf(text, sizeof text, "%s %.0f Mbit/s %.0f ms", rival.c_str(), line.Mbit_per_s, line.buffer_ms);
  return text;
}

std::vector<FlowRun> all_runs() {
  std::vector<FlowRun> runs;
  for (const SiteLine& line : kLines) {
    for (const char* algorithm : {"cubic", "bbr", "reno"})
      runs.push_back({.name = name_of(line, algorithm), .line = line, .rival = BulkFlow::Kind{algorithm}});
    runs.push_back({.name = name_of(line, "two sessions"), .line = line, .rival = {}});
    runs.push_back(
        {.name = name_of(line, "cubic beside TCP"), .line = line, .rival = BulkFlow::Kind{}, .by_tcp = true});
    runs.push_back({.name = name_of(line, "pages"), .line = line, .rival = BulkFlow::Kind{.page_B = kPage_B}});
    runs.push_back({.name = name_of(line, "upload"), .line = line, .rival = BulkFlow::Kind{.upload = true}});
  }
  return runs;
}

/// The rate of another flow during kBeside; nullopt: the kernel lacks its algorithm.
std::optional<double> rival_B_per_s(const TwoNetworks& networks, const FlowRun& run) {
  BulkFlow flow(networks, *run.rival, kRivalPort);
  std::this_thread::sleep_for(kBeside);
  if (flow.is_unknown()) return std::nullopt;
  return static_cast<double>(flow.received_B()) / to_seconds(kBeside);
}

Result<Measured> measure(const SitePlace& place, const FlowRun& run) {
  Result<std::unique_ptr<TwoNetworks>> networks = TwoNetworks::make(run.line);
  if (!networks) return networks.error();
  if (run.by_tcp)
    if (Result<void> blocked = (*networks)->block_udp(); !blocked) return blocked.error();
  const QueueWatch queue(**networks, run.line);
  std::vector<std::unique_ptr<TouchSession>> sessions;
  const auto begin = [&]() -> Result<void> {
    auto begun = TouchSession::begin(**networks, place.programs, place.scratch, static_cast<int>(sessions.size()));
    if (!begun) return begun.error();
    sessions.push_back(std::move(*begun));
    return {};
  };
  if (Result<void> begun = begin(); !begun) return begun.error();
  std::this_thread::sleep_for(kSettles + kAlone);
  FlowTimes times{.began = wall_clock(), .ended = {}, .alone = kAlone, .after = kAfter};
  Measured measured;
  if (run.rival) {
    const std::optional<double> rate = rival_B_per_s(**networks, run);
    if (!rate) return Measured{.lacks = "the kernel has no TCP by " + run.rival->congestion, .sessions = {}};
    measured.rival_B_per_s = *rate;
    times.ended = wall_clock();
    std::this_thread::sleep_for(kAfter);
    measured.standing_ms = queue.between_ms(times.ended + kStandsFrom, times.ended + kAfter).p50();
  } else {
    if (Result<void> begun = begin(); !begun) return begun.error();
    std::this_thread::sleep_for(kSettles);
    times.began = wall_clock();
    std::this_thread::sleep_for(kBeside);
    times.ended = wall_clock();
    measured.standing_ms = queue.between_ms(times.began + kStandsFrom, times.ended).p50();
  }
  for (auto& session : sessions) {
    const Result<TouchRecord> record = session->end();
    if (!record) return record.error();
    measured.sessions.push_back(outcome_of(*record, times, [&](Nanoseconds at) { return queue.at(at); }));
  }
  return measured;
}

/// Shares of what each one would get of a line that is shared fairly: nobody gets more than it asks for, and what one
/// leaves goes to the other.
void add_shares(std::vector<Row>& rows, const FlowRun& run, const Measured& measured) {
  const double line_B_per_s = run.line.Mbit_per_s * 1e6 / 8.0;
  const FlowOutcome& first = measured.sessions.front();
  const double ours = std::min(line_B_per_s / 2.0, first.alone_B_per_s);
  const double theirs = run.rival ? line_B_per_s - ours : ours;
  const double their_rate = run.rival ? measured.rival_B_per_s : measured.sessions.back().beside_B_per_s;
  rows.push_back(at_least(run.name + ": our share of the fair one", 100.0 * first.beside_B_per_s / ours, "%", 30.0));
  rows.push_back(at_least(run.name + ": their share of the fair one", 100.0 * their_rate / theirs, "%", 30.0));
}

void add_rows(std::vector<Row>& rows, const FlowRun& run, const Measured& measured) {
  for (std::size_t i = 0; i < measured.sessions.size(); ++i) {
    const FlowOutcome& ours = measured.sessions[i];
    const std::string name = run.name + (i == 0 ? "" : ", the other one");
    rows.push_back(at_least(name + ": images", ours.images_per_s, "/s", 20.0));
    rows.push_back(
        at_most(name + ": captured to touchable above the queue, p95", ours.above_queue_ms.quantile(0.95), "ms", 60.0));
    rows.push_back(bench::measured(name + ": captured to touchable, p95", ours.touchable_ms.quantile(0.95), "ms"));
    rows.push_back(at_most(name + ": released", 100.0 * ours.released, "%", 0.0));
  }
  const bool fills_the_line = !run.rival || (!run.rival->upload && run.rival->page_B == 0);
  if (fills_the_line) add_shares(rows, run, measured);
  if (run.rival) rows.push_back(at_most(run.name + ": back to full", measured.sessions.front().back_after_s, "s", 5.0));
  rows.push_back(at_most(run.name + ": queue left standing, p50", measured.standing_ms, "ms", 20.0));
}

}  // namespace

/// Defect that fails the rows: a sender without Competition, which yields until two images a second are left.
Result<SiteRows> run_flows_section(const SitePlace& place) {
  SiteRows section;
  if (const auto tried = TwoNetworks::make({}); !tried) {
    section.skipped.push_back("all flows, because " + to_string(tried.error()));
    return section;
  }
  for (const FlowRun& run : all_runs()) {
    if (!contains_one_of(run.name, place.wanted)) continue;
    std::fprintf(stderr, "telepalp-bench site: flows: %s\n", run.name.c_str());
    const Result<Measured> measured = measure(place, run);
    if (!measured) {
      std::fprintf(stderr, "telepalp-bench site: %s: %s\n", run.name.c_str(), to_string(measured.error()).c_str());
      section.rows.push_back(at_least(run.name + ": run that ended", 0.0, "", 1.0));
    } else if (!measured->lacks.empty()) {
      section.skipped.push_back(run.name + ", because " + measured->lacks);
    } else {
      add_rows(section.rows, run, *measured);
    }
  }
  return section;
}

}  // namespace telepalp::bench
