#include "tests/bench/accuracy/accuracy_station_cost.h"

namespace telepalp::bench {

Result<station::StationCost> cost_of_station(const scenes::Scene& scene, const std::string& name) {
  constexpr double kWarmUp_s = 1.0;
  constexpr double kMeasured_s = 8.0;
  const auto file = scenes::find_scene(name);
  if (!file) return file.error();
  const Result<station::SceneParts> parts = station::read_parts(scene, *file, true);
  if (!parts) return parts.error();
  static const station::BodyStream stream(station::SeenBody(), kWarmUp_s + kMeasured_s + 0.5);
  station::BilledStation billed(scene, *parts, stream);
  station::StationCost warm_up;
  billed.run(kWarmUp_s, warm_up);
  station::StationCost cost;
  billed.run(kMeasured_s, cost);
  return cost;
}

}  // namespace telepalp::bench
