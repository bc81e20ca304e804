#include "haptic_station/station/threads/bill.h"

#include <chrono>
#include <cstdio>
#include <thread>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace telepalp::station {
namespace {

std::string in_us(double us) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f us", us);
  return text;
}

}  // namespace

std::uint64_t cycles_now() noexcept {
#if defined(__x86_64__)
  return __rdtsc();
#else
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

double cycles_per_us() {
  static const double kRate = [] {
    const auto began = std::chrono::steady_clock::now();
    const std::uint64_t first = cycles_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const double us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - began).count();
    return static_cast<double>(cycles_now() - first) / us;
  }();
  return kRate;
}

Bill bill_of(const effects::EffectBank& effects) noexcept {
  Bill bill;
  for (const effects::EffectBill& line : effects.bill()) bill.lines[bill.count++] = line;
  return bill;
}

std::vector<msg::EffectCost> costs_of(const Bill& bill, double cycles_per_us) {
  std::vector<msg::EffectCost> costs;
  for (std::size_t index = 0; index < bill.count; ++index) {
    const effects::EffectBill& line = bill.lines[index];
    msg::EffectCost& cost = costs.emplace_back();
    cost.set_name(line.name);
    if (line.steps > 0)
      cost.set_mean_us(static_cast<double>(line.cost) / static_cast<double>(line.steps) / cycles_per_us);
    cost.set_max_us(static_cast<double>(line.largest) / cycles_per_us);
  }
  return costs;
}

std::string line_of(const std::vector<msg::EffectCost>& costs, double tick_us) {
  std::string line;
  double total_us = 0.0;
  for (const msg::EffectCost& cost : costs) {
    line += cost.name() + " " + in_us(cost.mean_us()) + ", ";
    total_us += cost.mean_us();
  }
  return line + "total " + in_us(total_us) + " of the " + in_us(tick_us) + " of a tick";
}

}  // namespace telepalp::station
