#include "tools/replay/storm/storm_case.h"

#include <array>
#include <cmath>
#include <random>
#include <string_view>

#include "tools/replay/words/network_options.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

constexpr auto kMotions =
    std::to_array<std::string_view>({"regular", "irregular", "cough", "hold", "speech", "shift", "drift", "sit-up"});
constexpr auto kScenes = std::to_array<std::string_view>({"skin", "palpation", "skin_sliding", "sphere", "friction"});

/// Every fourth case taps, the others examine. No case draws HandScript::Search.
constexpr std::array kHands{HandScript::Examine, HandScript::Examine, HandScript::Tap, HandScript::Examine};

/// Draws from std::mt19937_64, whose numbers the standard defines; its distributions are not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] double uniform(double least, double most) {
    return least + (most - least) * static_cast<double>(random_() >> 11U) * 0x1.0p-53;
  }
  [[nodiscard]] bool happens(double share) { return uniform(0.0, 1.0) < share; }
  /// Rounded, so that a command line holds it exactly.
  [[nodiscard]] double whole(double least, double most) { return std::round(uniform(least, most)); }
  [[nodiscard]] Nanoseconds milliseconds(double least, double most) {
    return Nanoseconds{std::llround(whole(least, most)) * 1'000'000};
  }
  [[nodiscard]] Window window(double shortest_ms, double longest_ms, double seconds) {
    return {milliseconds(500.0, 700.0 * seconds), milliseconds(shortest_ms, longest_ms)};
  }
  template <class T, std::size_t N>
  [[nodiscard]] const T& one_of(const std::array<T, N>& all) {
    return all[static_cast<std::size_t>(random_() % N)];
  }

 private:
  std::mt19937_64 random_;
};

impaired::Impairment draw_network(Draw& draw) {
  impaired::Impairment network{.delay = draw.milliseconds(0.0, 300.0)};
  if (draw.happens(0.7)) network.jitter = draw.milliseconds(0.0, 60.0);
  if (draw.happens(0.7)) network.loss = draw.whole(0.0, 20.0) / 100.0;
  if (draw.happens(0.5)) network.burst_packets = draw.whole(1.0, 12.0);
  if (draw.happens(0.3)) network.reorder = draw.whole(0.0, 10.0) / 100.0;
  if (draw.happens(0.3)) network.rate_B_per_s = draw.whole(4.0, 100.0) * 125'000.0;
  return network;
}

Faults draw_faults(Draw& draw, double seconds) {
  Faults faults;
  if (draw.happens(0.4)) faults.outages.push_back(draw.window(50.0, 3000.0, seconds));
  if (draw.happens(0.2)) faults.restarts.push_back(draw.window(100.0, 2500.0, seconds));
  if (draw.happens(0.3)) faults.tracker_lost.push_back(draw.window(50.0, 4000.0, seconds));
  if (draw.happens(0.3)) {
    const Window when = draw.window(1.0, 6.0, seconds);
    faults.glitches.push_back({when, draw.whole(-60.0, 60.0) * 1e-3});
  }
  if (draw.happens(0.2)) {
    const Window when = draw.window(200.0, 2000.0, seconds);
    faults.clock_steps.push_back({when, draw.milliseconds(-400.0, 400.0)});
  }
  return faults;
}

/// `value` as text with at most six decimals. The text is exact, because the storm draws only whole numbers.
std::string number(double value) {
  const std::string words = span_in_words(from_milliseconds(value));
  return words.substr(0, words.size() - 2);
}

std::string network_words(const impaired::Impairment& network) {
  std::string words = " --delay-ms " + number(to_milliseconds(network.delay));
  if (network.jitter > 0ns) words += " --jitter-ms " + number(to_milliseconds(network.jitter));
  if (network.loss > 0.0) words += " --loss " + number(100.0 * network.loss) + "%";
  if (network.loss > 0.0 && network.burst_packets > 1.0) words += " --burst " + number(network.burst_packets);
  if (network.reorder > 0.0) words += " --reorder " + number(100.0 * network.reorder) + "%";
  if (network.rate_B_per_s > 0.0) words += " --rate-kbps " + number(network.rate_B_per_s / 125.0);
  return words;
}

std::string fault_words(const Faults& faults) {
  std::string words;
  for (const Window& window : faults.outages) words += " --outage " + window_in_words(window);
  for (const Window& window : faults.restarts) words += " --restart " + window_in_words(window);
  for (const Window& window : faults.tracker_lost) words += " --tracker-lost " + window_in_words(window);
  for (const EncoderGlitch& glitch : faults.glitches)
    words += " --glitch " + window_in_words(glitch.when) + ":" + number(1e3 * glitch.off_m);
  for (const ClockStep& step : faults.clock_steps)
    words += " --clock-step " + window_in_words(step.when) + ":" + span_in_words(step.by);
  return words;
}

/// Removes one impairment from both directions of the network.
void set_network(StormCase& storm, void (*set)(impaired::Impairment& network)) {
  set(storm.scenario.down);
  set(storm.scenario.up);
  storm.scenario.deadline = usual_deadline(storm.scenario.down);
}

}  // namespace

StormCase draw_case(std::uint64_t seed) {
  Draw draw(seed);
  StormCase storm{.motion = std::string(draw.one_of(kMotions)),
                  .patient_seed = static_cast<std::uint64_t>(draw.whole(1.0, 1000.0)),
                  .scene = std::string(draw.one_of(kScenes)),
                  .scenario = {},
                  .seconds = draw.whole(7.0, 11.0)};
  storm.scenario.seed = seed;
  storm.scenario.down = storm.scenario.up = draw_network(draw);
  storm.scenario.deadline = usual_deadline(storm.scenario.down);
  storm.scenario.faults = draw_faults(draw, storm.seconds);
  if (draw.happens(0.1)) storm.width_px = 640;
  storm.scenario.hand = draw.one_of(kHands);
  return storm;
}

std::string source_of(const StormCase& storm) {
  return "synthetic:torso,motion=" + storm.motion + ",seed=" + std::to_string(storm.patient_seed) +
         ",width=" + std::to_string(storm.width_px);
}

std::string command_line(const StormCase& storm) {
  return source_of(storm) + " --scene " + storm.scene + " --hand " + std::string(name(storm.scenario.hand)) +
         " --seconds " + number(storm.seconds) + network_words(storm.scenario.down) +
         fault_words(storm.scenario.faults) + " --seed " + std::to_string(storm.scenario.seed) + " --check";
}

std::span<const Simplification> simplifications() noexcept {
  static constexpr auto kAll = std::to_array<Simplification>({
      [](StormCase& one) { one.scenario.faults.restarts.clear(); },
      [](StormCase& one) { one.scenario.faults.tracker_lost.clear(); },
      [](StormCase& one) { one.scenario.faults.glitches.clear(); },
      [](StormCase& one) { one.scenario.faults.clock_steps.clear(); },
      [](StormCase& one) { one.scenario.faults.outages.clear(); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.rate_B_per_s = 0.0; }); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.reorder = 0.0; }); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.burst_packets = 1.0; }); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.loss = 0.0; }); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.jitter = 0ns; }); },
      [](StormCase& one) { set_network(one, [](impaired::Impairment& i) { i.delay = 0ns; }); },
      [](StormCase& one) { one.motion = "regular"; },
      [](StormCase& one) { one.scenario.hand = HandScript::Examine; },
      [](StormCase& one) { one.patient_seed = 1; },
      [](StormCase& one) { one.scene = "skin"; },
  });
  return kAll;
}

}  // namespace telepalp::replay
