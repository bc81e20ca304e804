#include "tools/replay/words/network_options.h"

#include "proto/impaired/profiles.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

using impaired::Impairment;

constexpr double kLongest_ms = 60e3;

/// An option that sets one number of both directions.
struct Figure {
  program::Option option;
  double most;
  void (*set)(Impairment& impairment, double value);
};
const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {{"delay-ms", "MS", "network delay in each direction"},
       kLongest_ms,
       [](Impairment& i, double v) { i.delay = from_milliseconds(v); }},
      {{"jitter-ms", "MS", "uniform variation of the delay, plus or minus MS"},
       kLongest_ms,
       [](Impairment& i, double v) { i.jitter = from_milliseconds(v); }},
      {{"burst", "N", "mean length of a loss burst, in packets"},
       1e4,
       [](Impairment& i, double v) { i.burst_packets = v; }},
      {{"rate-kbps", "R", "rate of the bottleneck in kbit/s; 0: unlimited"},
       1e8,
       [](Impairment& i, double v) { i.rate_B_per_s = v * 125.0; }},
  };
  return all;
}

struct Share {
  program::Option option;
  double Impairment::*share;
};
const std::vector<Share>& shares() {
  static const std::vector<Share> all{
      {{"loss", "P", "share of the packets that is lost: 5% or 0.05"}, &Impairment::loss},
      {{"reorder", "P", "share of the packets that is reordered: 1% or 0.01"}, &Impairment::reorder}};
  return all;
}

Result<void> apply_profile(const program::Arguments& arguments, Scenario& scenario) {
  if (!arguments.has("profile")) return {};
  const Result<impaired::Profile> profile = impaired::profile_named(arguments.text("profile"));
  if (!profile) return profile.error();
  scenario.down = profile->down;
  scenario.up = profile->up;
  return {};
}

Result<void> apply_figures(const program::Arguments& arguments, Scenario& scenario) {
  for (const Figure& figure : figures()) {
    if (!arguments.has(figure.option.name)) continue;
    const Result<double> value = arguments.number(figure.option.name, 0.0, figure.most);
    if (!value) return value.error();
    figure.set(scenario.down, *value);
    figure.set(scenario.up, *value);
  }
  for (const Share& share : shares()) {
    if (!arguments.has(share.option.name)) continue;
    const Result<double> value = parse_share(arguments.text(share.option.name), share.option.name);
    if (!value) return value.error();
    scenario.down.*share.share = scenario.up.*share.share = *value;
  }
  return {};
}

/// Sets `target` to the parsed text of `option`, if it is given.
template <class T, class Parse>
Result<void> apply_words(const program::Arguments& arguments, std::string_view option, Parse parse, T& target) {
  if (!arguments.has(option)) return {};
  Result<T> parsed = parse(arguments.text(option), option);
  if (!parsed) return parsed.error();
  target = std::move(*parsed);
  return {};
}

Result<void> apply_faults(const program::Arguments& arguments, Faults& faults) {
  for (const auto& [option, windows] :
       {std::pair{"outage", &faults.outages}, {"restart", &faults.restarts}, {"tracker-lost", &faults.tracker_lost}})
    if (const Result<void> applied = apply_words(arguments, option, parse_windows, *windows); !applied) return applied;
  if (const Result<void> applied = apply_words(arguments, "glitch", parse_glitches, faults.glitches); !applied)
    return applied;
  return apply_words(arguments, "clock-step", parse_clock_steps, faults.clock_steps);
}

}  // namespace

std::vector<program::Option> network_options() {
  std::vector<program::Option> options{{"profile", "NAME", "a network by name: lan, lte, satellite or hostile"}};
  for (const Figure& figure : figures()) options.push_back(figure.option);
  for (const Share& share : shares()) options.push_back(share.option);
  options.insert(options.end(), {{"outage", "10s+500ms", "10 s after the start, no packet arrives for 500 ms"},
                                 {"restart", "10s+2s", "at 10 s the server stops, and restarts 2 s later"},
                                 {"tracker-lost", "10s+2s", "at 10 s the tracker stops, and resumes 2 s later"},
                                 {"glitch", "10s+4ms:MM", "at 10 s the device's position is MM mm off for 4 ms"},
                                 {"clock-step", "10s+2s:60ms", "at 10 s the station's clock is 60 ms ahead for 2 s"},
                                 {"deadline-ms", "MS", "a frame older than MS on arrival is late [100+delay]"},
                                 {"seed", "N", "random seed; with --storm: the first seed", "1"}});
  return options;
}

Result<Scenario> read_scenario(const program::Arguments& arguments) {
  Scenario scenario;
  if (const Result<void> applied = apply_profile(arguments, scenario); !applied) return applied.error();
  if (const Result<void> applied = apply_figures(arguments, scenario); !applied) return applied.error();
  if (const Result<void> applied = apply_faults(arguments, scenario.faults); !applied) return applied.error();
  const Result<std::int64_t> seed = arguments.whole("seed", 0, std::int64_t{1} << 53);
  if (!seed) return seed.error();
  scenario.seed = static_cast<std::uint64_t>(*seed);
  scenario.deadline = usual_deadline(scenario.down);
  if (!arguments.has("deadline-ms")) return scenario;
  const Result<double> deadline_ms = arguments.number("deadline-ms", 1.0, kLongest_ms);
  if (!deadline_ms) return deadline_ms.error();
  scenario.deadline = from_milliseconds(*deadline_ms);
  return scenario;
}

}  // namespace telepalp::replay
