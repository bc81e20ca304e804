#include "haptic_station/station/threads/bill.h"

#include <cstdio>

namespace telepalp::station {
namespace {

std::string in_us(double us) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f us", us);
  return text;
}

}  // namespace

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
  return line + "total " + in_us(total_us) + " of " + in_us(tick_us);
}

}  // namespace telepalp::station
