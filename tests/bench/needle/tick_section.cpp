#include <string>

#include "haptic_station/core/built_effects.h"
#include "tests/bench/needle/section.h"
#include "tests/bench/tick_times.h"

namespace telepalp::bench {
std::vector<Row> run_needle_tick_section() {
  std::vector<Row> rows;
  for (const std::string_view name : kNeedleScenes) {
    const scenes::Scene scene = library_scene(name);
    const TickTimes took = measure_ticks(core::bank_of(scene.effects), scene.trial, device::duration_s(scene.trial));
    const std::string tick = std::string(name) + ": tick: time, ";
    rows.push_back(at_most(tick + "p50", took.all.p50(), "us", 20.0));
    rows.push_back(at_most(tick + "p99.9", took.all.p999(), "us", 100.0));
    rows.push_back(measured(tick + "p50 in contact", took.contact.p50(), "us"));
    rows.push_back(measured(std::string(name) + ": tick: processor time, p99.9", took.processor.p999(), "us"));
    rows.push_back(measured(std::string(name) + ": ticks in contact", static_cast<double>(took.contact.count()), ""));
  }
  return rows;
}

}  // namespace telepalp::bench
