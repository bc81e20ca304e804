#include "haptic_station/trials/blind_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/trials/loop_station.h"

namespace telepalp::trials {
namespace {

constexpr double kHalfWidth_m = 0.05;  // half side of the searched square, about the middle of the skin
constexpr double kTremor_m = 0.0005;   // amplitude of the hand's tremor at 9 Hz
constexpr double kWeber = 0.10;  // standard deviation of the perceived force as a share of the force (Weber fraction)
constexpr int kPlacesASide = 4;
constexpr double kLeg_s[] = {0.55, 0.35, 0.30, 0.40};  // durations: over the place, down to the skin, into it, out
constexpr double kPress_s = 1.6;                       // sum of all four
constexpr double kPressTo_m = -0.065;
constexpr double kFeelBelow_m = 0.025;       // a shallower press does not reveal an object below the skin
constexpr double kFelt_N_per_m = 20.0;       // least stiffness of a felt place; the skin alone has three times as much
constexpr double kStifferThanMedian = 1.33;  // ratio to the median stiffness from which the person reports an object

struct Place {
  double x_m;
  double z_m;
  double stiffest_N_per_m = 0.0;
};

std::vector<Place> grid() {
  std::vector<Place> places;
  for (int i = 0; i < kPlacesASide * kPlacesASide; ++i) {
    const auto along = [&](int n) { return kHalfWidth_m * (2.0 * n / (kPlacesASide - 1) - 1.0); };
    const int row = i / kPlacesASide;
    const int column = row % 2 == 0 ? i % kPlacesASide : kPlacesASide - 1 - i % kPlacesASide;
    places.push_back({along(column), along(row)});
  }
  return places;
}

std::vector<device::Waypoint> presses(const std::vector<Place>& places) {
  std::vector<device::Waypoint> script;
  for (const Place& place : places) {
    script.push_back({kLeg_s[0], place.x_m, 0.06, place.z_m});
    script.push_back({kLeg_s[1], place.x_m, 0.01, place.z_m});
    script.push_back({kLeg_s[2], place.x_m, kPressTo_m, place.z_m});
    script.push_back({kLeg_s[3], place.x_m, 0.06, place.z_m});
  }
  return script;
}

VirtualStationSettings scene(const BlindSearchSettings& settings, const Point<HapticBase>& cylinder) {
  VirtualStationSettings station;
  station.seed = settings.seed;
  station.control.transitions.dwell_s = 0.1;  // shorter than S1's, because the script is fast
  std::vector<effects::Recipe> recipes{effects::SkinSettings{}};
  if (settings.with_cylinder)
    recipes.emplace_back(effects::InnerCylinderSettings{.top_center = {cylinder.m - Eigen::Vector3d{0.0, 0.03, 0.0}}});
  station.effects = core::bank_of(recipes);
  return station;
}

double median_stiffness(std::vector<Place> places) {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.stiffest_N_per_m < b.stiffest_N_per_m; });
  return places[places.size() / 2].stiffest_N_per_m;
}

}  // namespace

BlindSearchOutcome search_blindly(const BlindSearchSettings& settings) {
  device::Random random(settings.seed);
  BlindSearchOutcome outcome;
  outcome.cylinder.m = {random.uniform(-kHalfWidth_m, kHalfWidth_m), 0.0, random.uniform(-kHalfWidth_m, kHalfWidth_m)};
  const double breath_begins_s = random.uniform(0.0, 4.0);
  std::vector<Place> places = grid();
  const std::vector<device::Waypoint> script = presses(places);
  const std::unique_ptr<TrialSkin> skin =
      settings.by_camera
          ? camera_skin({.breathing_m = settings.breathing_m, .begins_s = breath_begins_s, .seed = settings.seed})
          : level_skin({.amplitude_m = settings.breathing_m}, breath_begins_s);
  LoopStation station(scene(settings, outcome.cylinder), *skin);
  station.place({{0.0, 0.03, 0.0}}, {{script.back().x_m, script.back().height_m, script.back().z_m}});
  device::ScriptedIntention person(script, {});
  const double tick_s = 0.0005;
  const auto ticks = static_cast<int>(kPress_s * static_cast<double>(places.size()) / tick_s);
  for (int i = 0; i < ticks; ++i) {
    const double now_s = station.time_s();
    (void)station.step([&](const device::TrialView& view) {
      device::Intention aim = person.step(view, tick_s);
      aim.at.m.y() += kTremor_m * std::sin(2.0 * std::numbers::pi * 9.0 * now_s);
      return aim;
    });
    const double depth_m = station.true_depth_m();
    if (depth_m < kFeelBelow_m) continue;
    Place& place = places[std::min(places.size() - 1, static_cast<std::size_t>(now_s / kPress_s))];
    place.stiffest_N_per_m = std::max(place.stiffest_N_per_m, station.pair().felt().N.norm() / depth_m);
  }
  for (const Place& place : places) outcome.places_unfelt += place.stiffest_N_per_m < kFelt_N_per_m ? 1 : 0;
  for (Place& place : places) place.stiffest_N_per_m *= 1.0 + kWeber * random.normal();
  const auto stiffest = std::max_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.stiffest_N_per_m < b.stiffest_N_per_m;
  });
  outcome.where.m = {stiffest->x_m, 0.0, stiffest->z_m};
  outcome.strongest_ratio = stiffest->stiffest_N_per_m / std::max(median_stiffness(places), 1e-9);
  outcome.found = outcome.places_unfelt == 0 && outcome.strongest_ratio > kStifferThanMedian;
  return outcome;
}

}  // namespace telepalp::trials
