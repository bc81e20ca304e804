#include "haptic_station/station/commands/scene_bill.h"

#include <cmath>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/station/threads/bill.h"

namespace telepalp::station {
namespace {

constexpr double kTick_s = 0.0005;
constexpr int kTicks = 20'000;

/// A path over the whole workspace that presses and lets go four times a second.
Point<HapticBase> pressed_at(double time_s) {
  const double depth_m = 0.04 * std::pow(std::sin(4.0 * time_s), 2.0);
  return {{0.12 * std::sin(0.7 * time_s), -depth_m, 0.12 * std::sin(1.1 * time_s + 0.4)}};
}

}  // namespace

std::vector<EffectPrice> price_of(const scenes::Scene& scene) {
  effects::EffectBank bank = scene.effects;
  const device::BreathingPlane skin;
  effects::EffectInput in;
  in.device = pressed_at(0.0);
  in.contact = skin(in.device, 0.0);
  bank.begin(in);
  for (int i = 1; i <= kTicks; ++i) {
    const Point<HapticBase> next = pressed_at(i * kTick_s);
    in.moved = next - in.device;
    in.device_velocity.v = in.moved.v / kTick_s;
    in.device = next;
    in.contact = skin(next, 0.0);
    (void)bank.step(in, kTick_s, &cycles_now);
  }
  std::vector<EffectPrice> prices;
  for (const effects::EffectBill& line : bank.bill()) {
    EffectPrice& price = prices.emplace_back();
    price.name = line.name;
    price.mean_us = static_cast<double>(line.cost) / static_cast<double>(line.steps) / cycles_per_us();
    price.largest_us = static_cast<double>(line.largest) / cycles_per_us();
    for (const auto& layer : scene.layers) {
      if (layer->name != price.name) continue;
      price.shapes = layer->tree->shapes;
      price.bytes = layer->tree->bytes();
    }
  }
  return prices;
}

}  // namespace telepalp::station
