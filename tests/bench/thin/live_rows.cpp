#include "tests/bench/thin/live_rows.h"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <filesystem>
#include <future>
#include <ranges>
#include <thread>
#include <utility>
#include <vector>

#include "support/program/files/shipped.h"
#include "tests/bench/distribution.h"
#include "tests/bench/thin/live_hand.h"
#include "tests/bench/thin/recorded_room.h"
#include "tests/support/child_process.h"
#include "tools/link_proxy/link_proxy.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kMbit = 1e6 / 8.0;  // [B]
constexpr double kSettle_s = 3.0;    // from this time on, the rates must be steady

/// A line that is the same in both directions: 50 ms there and back, a buffer of 500 ms.
impaired::Impairment line_of(double Mbit_per_s, double loss) {
  return {.delay = 25ms,
          .loss = loss,
          .rate_B_per_s = Mbit_per_s * kMbit,
          .queue_B = static_cast<std::size_t>(0.5 * Mbit_per_s * kMbit)};
}

/// telepalp-link's proxy in front of a server, on a thread of its own.
class Line {
 public:
  static Result<std::unique_ptr<Line>> begin(std::uint16_t server, const impaired::Impairment& both,
                                             const impaired::Trace& trace) {
    std::unique_ptr<Line> line(new Line());
    auto proxy = link_proxy::LinkProxy::start(line->io_, {.listen = {.host = "127.0.0.1", .port = 0},
                                                          .server = {.host = "127.0.0.1", .port = server},
                                                          .down = both,
                                                          .up = both,
                                                          .trace = trace});
    if (!proxy) return proxy.error();
    line->proxy_ = std::move(*proxy);
    line->thread_ = std::thread([raw = line.get()] { raw->io_.run(); });
    return line;
  }
  ~Line() {
    boost::asio::post(io_, [this] { proxy_->stop(); });
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return proxy_->port(); }

  /// Bytes that have crossed the line towards the hand.
  [[nodiscard]] double delivered_B() {
    std::promise<std::string> totals;
    boost::asio::post(io_, [&] { totals.set_value(proxy_->totals_json()); });
    const std::string json = totals.get_future().get();
    const std::string key = "\"delivered_bytes\":";
    const std::size_t at = json.find(key, json.find("\"down\""));
    return at == std::string::npos ? 0.0 : std::stod(json.substr(at + key.size()));
  }

 private:
  Line() = default;
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ = make_work_guard(io_);
  std::unique_ptr<link_proxy::LinkProxy> proxy_;
  std::thread thread_;
};

struct Run {
  HandRecord record;
  std::vector<std::pair<double, double>> delivered;  ///< time since the start [s], Line::delivered_B() until then
};

Result<Run> run_hand(const std::string& source, const impaired::Impairment& both, const impaired::Trace& trace,
                     double seconds) {
  const support::TemporaryFolder folder;
  const std::filesystem::path ready = folder.path() / "ready";
  const std::filesystem::path program = program::sibling_program("telepalp-server");
  const Error not_started{.what = "telepalp-server did not start",
                          .where = program.string(),
                          .fix = "build all programs: ninja telepalp_programs"};
  if (!std::filesystem::exists(program)) return not_started;
  support::ChildProcess server(program, {"--source", source, "--port", "0", "--ready-file", ready.string()},
                               folder.path() / "log");
  const std::optional<std::string> port = support::await_ready(ready, "port");
  if (!port) return not_started;
  auto line = Line::begin(static_cast<std::uint16_t>(std::stoi(*port)), both, trace);
  if (!line) return line.error();
  Run run;
  LiveHand hand((*line)->port());
  while (hand.now_s() < seconds) {
    run.delivered.emplace_back(hand.now_s(), (*line)->delivered_B());
    std::this_thread::sleep_for(100ms);
  }
  run.record = hand.end();
  return run;
}

/// Rate of events [1/s]. `at`: the time of one [s].
template <class Events, class At>
double rate(Events&& events, double from_s, double until_s, At at) {
  const auto count =
      std::ranges::count_if(events, [&](const auto& one) { return at(one) >= from_s && at(one) < until_s; });
  return static_cast<double>(count) / (until_s - from_s);
}

double color_rate(const Run& run, double from_s, double until_s) {
  return rate(run.record.color_s, from_s, until_s, [](double at_s) { return at_s; });
}

/// Rate of surfaces that are exact where the hand is [1/s].
double window_rate(const Run& run, double from_s, double until_s) {
  return rate(run.record.surfaces | std::views::filter(&HandRecord::Touchable::inside), from_s, until_s,
              [](const HandRecord::Touchable& one) { return one.at_s; });
}

Distribution ages_ms(const Run& run, double from_s, double until_s) {
  Distribution ages;
  for (const HandRecord::Touchable& one : run.record.surfaces)
    if (one.at_s >= from_s && one.at_s < until_s) ages.add(1e3 * (one.at_s - one.captured_s));
  return ages;
}

double longest_gap_ms(const Run& run, double from_s, double until_s) {
  double last_s = from_s;
  double longest_s = 0.0;
  for (const HandRecord::Touchable& one : run.record.surfaces) {
    if (one.at_s < from_s || one.at_s >= until_s) continue;
    longest_s = std::max(longest_s, one.at_s - last_s);
    last_s = one.at_s;
  }
  return 1e3 * std::max(longest_s, until_s - last_s);
}

/// Share of the line that was used [%].
double use_percent(const Run& run, double from_s, double until_s, double rate_B_per_s) {
  const auto at = [&](double when_s) {
    const auto found = std::ranges::find_if(run.delivered, [&](const auto& one) { return one.first >= when_s; });
    return found == run.delivered.end() ? run.delivered.back() : *found;
  };
  const auto [first_s, first_B] = at(from_s);
  const auto [last_s, last_B] = at(until_s);
  return 100.0 * (last_B - first_B) / std::max(1e-3, last_s - first_s) / rate_B_per_s;
}

/// The first time from which both rates are reached for two seconds; `until_s` if there is none.
double steady_from_s(const Run& run, double window_hz, double color_hz, double from_s, double until_s) {
  for (double at_s = from_s; at_s + 2.0 <= until_s; at_s += 0.1) {
    const auto holds = [&](double second) {
      return window_rate(run, second, second + 1.0) >= window_hz && color_rate(run, second, second + 1.0) >= color_hz;
    };
    if (holds(at_s) && holds(at_s + 1.0)) return at_s;
  }
  return until_s;
}

void add_sentences(Report& report, const std::string& name, const Run& run) {
  std::string last;
  for (const std::string& said : run.record.said)
    if (!said.empty()) last = said;
  report.notes.push_back(name + ", the server says: " + (last.empty() ? "nothing" : last));
}

struct SteadyReach {
  double Mbit_per_s;
  double window_hz;
  double color_hz;  ///< 0: the rows of colour, gaps and use have no budget
  double age_ms;
};

Result<void> add_steady_rows(Report& report, const std::string& name, const std::string& source,
                             const SteadyReach& reach) {
  constexpr double kUntil_s = 15.0;
  const Result<Run> run = run_hand(source, line_of(reach.Mbit_per_s, 0.01), {}, kUntil_s);
  if (!run) return run.error();
  const std::string line = name + ", " + std::to_string(static_cast<int>(reach.Mbit_per_s)) + " Mbit/s: ";
  report.rows.push_back(
      at_least(line + "exact depth around the hand", window_rate(*run, kSettle_s, kUntil_s), "1/s", reach.window_hz));
  const double color = color_rate(*run, kSettle_s, kUntil_s);
  report.rows.push_back(reach.color_hz > 0.0 ? at_least(line + "colour", color, "1/s", reach.color_hz)
                                             : measured(line + "colour", color, "1/s"));
  report.rows.push_back(at_most(line + "capture to touchable, p95", ages_ms(*run, kSettle_s, kUntil_s).quantile(0.95),
                                "ms", reach.age_ms));
  const double use = use_percent(*run, kSettle_s, kUntil_s, reach.Mbit_per_s * kMbit);
  if (reach.color_hz > 0.0) {
    report.rows.push_back(at_most(line + "steady after",
                                  steady_from_s(*run, reach.window_hz, reach.color_hz, 0.0, kUntil_s), "s", kSettle_s));
    report.rows.push_back(
        at_most(line + "longest gap between surfaces", longest_gap_ms(*run, kSettle_s, kUntil_s), "ms", 300.0));
    report.rows.push_back(at_least(line + "use of the line", use, "%", 80.0));
  } else {
    report.rows.push_back(
        measured(line + "longest gap between surfaces", longest_gap_ms(*run, kSettle_s, kUntil_s), "ms"));
    report.rows.push_back(measured(line + "use of the line", use, "%"));
  }
  add_sentences(report, name + ", " + std::to_string(static_cast<int>(reach.Mbit_per_s)) + " Mbit/s", *run);
  return {};
}

Result<void> add_fall_rows(Report& report, const std::string& name, const std::string& source) {
  constexpr double kFall_s = 8.0, kBack_s = 20.0, kUntil_s = 30.0;
  const auto row = [](double at_s, double Mbit_per_s) {
    return impaired::TraceRow{.at = from_seconds(at_s), .delay = 25ms, .rate_B_per_s = Mbit_per_s * kMbit};
  };
  impaired::Impairment both = line_of(2.0, 0.0);
  both.rate_B_per_s = 20.0 * kMbit;
  const Result<Run> run =
      run_hand(source, both, {row(0.0, 20.0), row(kFall_s, 2.0), row(kBack_s, 20.0), row(60.0, 20.0)}, kUntil_s);
  if (!run) return run.error();
  const std::string line = name + ", 20 to 2 Mbit/s and back: ";
  const double full_window = window_rate(*run, kSettle_s, kFall_s);
  const double full_color = color_rate(*run, kSettle_s, kFall_s);
  report.rows.push_back(at_most(line + "capture to touchable during the fall, p95",
                                ages_ms(*run, kFall_s, kBack_s).quantile(0.95), "ms", 250.0));
  const double back_s = steady_from_s(*run, 0.93 * full_window, 0.93 * full_color, kBack_s, kUntil_s) - kBack_s;
  report.rows.push_back(at_most(line + "back to full after", back_s, "s", 5.0));
  report.rows.push_back(measured(line + "exact depth before the fall", full_window, "1/s"));
  report.rows.push_back(measured(line + "colour before the fall", full_color, "1/s"));
  report.rows.push_back(measured(line + "exact depth during the fall", window_rate(*run, kFall_s, kBack_s), "1/s"));
  report.rows.push_back(measured(line + "colour during the fall", color_rate(*run, kFall_s, kBack_s), "1/s"));
  report.rows.push_back(
      measured(line + "longest gap between surfaces", longest_gap_ms(*run, kSettle_s, kUntil_s), "ms"));
  return {};
}

}  // namespace

Result<void> add_live_rows(Report& report, const std::string& input) {
  std::vector<std::pair<std::string, std::string>> sources{{"recorded room", std::string("oni:") + kRoom},
                                                           {"synthetic patient", "synthetic"}};
  if (!input.empty()) sources = {{input, input}};
  for (const auto& [name, source] : sources) {
    for (const SteadyReach& reach :
         {SteadyReach{.Mbit_per_s = 4.0, .window_hz = 25.0, .color_hz = 10.0, .age_ms = 150.0},
          SteadyReach{.Mbit_per_s = 2.0, .window_hz = 15.0, .color_hz = 0.0, .age_ms = 250.0}})
      if (const auto added = add_steady_rows(report, name, source, reach); !added) return added.error();
    if (const auto added = add_fall_rows(report, name, source); !added) return added.error();
  }
  report.notes.emplace_back(
      "live: a real server, link and sockets; 50 ms there and back, a buffer of 500 ms, 1 % loss (none during the "
      "fall); the hand takes depth with a window and VP8 by one connection, and moves in a circle at 0.13 m/s");
  report.notes.emplace_back("live: voice is not sent, so the rows say nothing of it");
  return {};
}

}  // namespace telepalp::bench
