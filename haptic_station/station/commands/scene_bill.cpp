#include "haptic_station/station/commands/scene_bill.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/organs/organ_shape.h"
#include "haptic_station/station/threads/bill.h"

namespace telepalp::station {
namespace {

constexpr double kTick_s = 0.0005;
constexpr int kTicks = 20'000;
constexpr int kTicksPerPart = 1000;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A path over the whole workspace that presses and lets go every 0.8 s.
Point<HapticBase> pressed_at(double time_s) {
  const double depth_m = 0.04 * std::pow(std::sin(4.0 * time_s), 2.0);
  return {{0.12 * std::sin(0.7 * time_s), -depth_m, 0.12 * std::sin(1.1 * time_s + 0.4)}};
}

/// Cost of one effect: its bill so far, and its mean cost per tick in each part of the path [us].
struct Cost {
  effects::EffectBill so_far;
  std::vector<double> parts_us{};
};

void end_part(std::span<const effects::EffectBill> bill, std::vector<Cost>& costs) {
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const auto cycles = static_cast<double>(bill[i].cost - costs[i].so_far.cost);
    costs[i].parts_us.push_back(cycles / kTicksPerPart / cycles_per_us());
    costs[i].so_far = bill[i];
  }
}

std::vector<Cost> costs_on_the_path(effects::EffectBank& bank) {
  const device::BreathingPlane skin;
  effects::EffectInput in;
  in.device = pressed_at(0.0);
  in.contact = skin(in.device, 0.0);
  bank.begin(in);
  std::vector<Cost> costs;
  for (const effects::EffectBill& line : bank.bill()) costs.push_back({line});
  for (int i = 1; i <= kTicks; ++i) {
    const Point<HapticBase> next = pressed_at(i * kTick_s);
    in.moved = next - in.device;
    in.device_velocity.v = in.moved.v / kTick_s;
    in.device = next;
    in.contact = skin(next, 0.0);
    (void)bank.step(in, kTick_s, std::numeric_limits<double>::infinity(), &cycles_now);
    if (i % kTicksPerPart == 0) end_part(bank.bill(), costs);
  }
  return costs;
}

/// Error of the felt depth, in words, compared with the effect's formula or with the effect's finest setting.
std::string depth_error_of(const msg::Effect& effect, const effects::SolidLayer* layer) {
  char words[64];
  if (effect.has_cylinder()) return "0.5 % of the depth, near the cylinder's rounded edges only";
  if (layer != nullptr && !layer->tree->lattices.empty()) {
    std::snprintf(words, sizeof words, "depends on the mesh, sampled every %.3g mm",
                  1e3 * layer->tree->lattices.front()->spacing_m);
    return words;
  }
  if (effect.has_organ()) {
    const double cell_m = effect.organ().has_cell_m() ? effect.organ().cell_m() : organs::OrganShapeSettings{}.cell_m;
    std::snprintf(words, sizeof words, "depends on the mesh, sampled every %.3g mm", 1e3 * cell_m);
    return words;
  }
  if (layer == nullptr) return "none: computed by a formula";
  std::snprintf(words, sizeof words, "%.3g um while the hand rests", 1e6 * solids::ProxySettings{}.tolerance_m);
  return words;
}

}  // namespace

std::vector<EffectPrice> price_of(const scenes::Scene& scene) {
  effects::EffectBank bank = scene.effects;
  std::vector<EffectPrice> prices;
  for (Cost& cost : costs_on_the_path(bank)) {
    EffectPrice& price = prices.emplace_back();
    price.name = cost.so_far.name;
    price.mean_us = median(std::move(cost.parts_us));
    price.largest_us = static_cast<double>(cost.so_far.largest) / cycles_per_us();
    const std::size_t effect = prices.size() - 1;
    const auto at = std::ranges::find(scene.layers, effect, &scenes::SceneLayer::effect);
    const effects::SolidLayer* const layer = at == scene.layers.end() ? nullptr : at->solid.get();
    price.depth_error = depth_error_of(scene.message.effects(static_cast<int>(effect)), layer);
    if (layer == nullptr) continue;
    price.shapes = layer->tree->shapes;
    price.bytes = layer->tree->bytes();
  }
  return prices;
}

}  // namespace telepalp::station
