#include <cstdio>

#include "haptic_station/station/bill/scene_bill.h"

namespace telepalp::station {
namespace {

constexpr const char* kSteps[kPartCount] = {"control loop, a tick", "surface, an image", "collision, a plane",
                                            "ultrasound, an image", "messages, 10 ms",   "slow effects, a run"};

template <class... Values>
void print(std::string& text, const char* format, Values... values) {
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  text += line;
}

std::string steps_table(const SceneBill& bill) {
  std::string text;
  print(text, "%-22s %10s %10s %14s\n", "part of the station", "p50, us", "p99.9, us", "% of a core");
  for (std::size_t i = 0; i < kPartCount; ++i) {
    const auto part = static_cast<Part>(i);
    const core::DurationHistogram& steps = bill.live.steps[i];
    if (steps.total() == 0) continue;
    print(text, "%-22s %10.1f %10.1f %14.2f\n", kSteps[i], 1e-3 * steps.quantile_ns(0.5),
          1e-3 * steps.quantile_ns(0.999), bill.live.share(part));
  }
  if (bill.receiving_us > 0.0)
    print(text, "%-22s %10s %10s %14.2f\n", "receiving the images", "", "", bill.receiving_share());
  print(text, "%-22s %10s %10s %14.2f\n", "station", "", "", bill.share());
  return text;
}

std::string price_line(const Price& price) {
  const auto share = [&](Part part) { return price.share[static_cast<std::size_t>(part)]; };
  std::string text;
  print(text, "%-16s %7.2f %7.2f %7.2f %7.2f %7.2f", price.name.c_str(), price.total_share,
        share(Part::Loop) + share(Part::Collision) + share(Part::Effects), share(Part::Surface), share(Part::Inside),
        share(Part::Messages));
  if (!price.error) return text + "\n";
  print(text, " %9.3f %8zu", price.tick_us, price.bytes);
  const MovingError& error = *price.error;
  if (!error.compared) return text + "  by a slow stage; telepalp-bench needle --part hand-over measures its error\n";
  if (error.ticks == 0) return text + "  gives no force in this trial\n";
  print(text, "  %7.1f %7.1f", 1e3 * error.p50_N, 1e3 * error.p99_N);
  if (error.stiffness_N_per_m > 0.0)
    print(text, " %7.0f %7.0f", 1e6 * error.p50_N / error.stiffness_N_per_m,
          1e6 * error.p99_N / error.stiffness_N_per_m);
  return text + "\n";
}

}  // namespace

std::string in_words(const SceneBill& bill) {
  std::string text = steps_table(bill);
  if (bill.start_ms > 0.0) print(text, "the surfaces of the layers, once at the start: %.0f ms\n", bill.start_ms);
  text +=
      "\nwhat each effect adds, as the station with it less the station without it\n"
      "                              % of a core                   in a tick   memory  error in motion: force and "
      "depth\n";
  print(text, "%-16s %7s %7s %7s %7s %7s %9s %8s  %7s %7s %7s %7s\n", "effect", "station", "loop", "surface", "inside",
        "messag.", "mean, us", "tree, B", "p50, mN", "p99, mN", "p50, um", "p99, um");
  for (const Price& price : bill.prices) text += price_line(price);
  return text;
}

}  // namespace telepalp::station
