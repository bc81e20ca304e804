#include "clients/mixed/hand/hand_colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "proto/words/demand.h"

namespace telepalp::mixed {
namespace {

constexpr double kLevelNoise = 3.0 / 255.0;  // of one channel; it makes the hue of a grey uncertain
constexpr double kLeast = 1e-6;

/// sqrt(x² + y²). std::hypot guards against overflow, too, and takes ten times as long.
double length(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

/// The angle from one hue to another, the shorter way round [rad]. Both hues: from -pi to pi.
double angle_between(double from_rad, double to_rad) noexcept {
  const double across_rad = to_rad - from_rad;
  if (across_rad > std::numbers::pi) return across_rad - 2.0 * std::numbers::pi;
  if (across_rad < -std::numbers::pi) return across_rad + 2.0 * std::numbers::pi;
  return across_rad;
}

}  // namespace

Hsi hsi_of(const Rgb& rgb) noexcept {
  const double r = rgb[0] / 255.0, g = rgb[1] / 255.0, b = rgb[2] / 255.0;
  Hsi hsi;
  hsi.intensity = (r + g + b) / 3.0;
  if (hsi.intensity > 0.0) hsi.saturation = 1.0 - std::min({r, g, b}) / hsi.intensity;
  const double across = std::numbers::sqrt3 * (g - b), along = 2.0 * r - g - b;
  if (across != 0.0 || along != 0.0) hsi.hue_rad = std::atan2(across, along);
  return hsi;
}

double mahalanobis(const HandColour& hand, const Hsi& colour) noexcept {
  const double chroma = std::max(colour.saturation * colour.intensity, kLeast);
  const double hue_rad = angle_between(hand.key.hue_rad, colour.hue_rad);
  const double hue = hue_rad / length(hand.hue_deviation_rad, kLevelNoise / chroma);
  const double saturation = (colour.saturation - hand.key.saturation) /
                            length(hand.saturation_deviation, kLevelNoise / std::max(colour.intensity, kLeast));
  const double intensity = (colour.intensity - hand.key.intensity) / hand.intensity_deviation;
  return std::sqrt(hue * hue + saturation * saturation + intensity * intensity);
}

HandColour fit_hand_colour(std::span<const Rgb> samples) {
  demand(!samples.empty(), "a colour is fitted to at least one sample");
  const double n = static_cast<double>(samples.size());
  HandColour fit;
  double east = 0.0, north = 0.0;
  for (const Rgb& rgb : samples) {
    const Hsi hsi = hsi_of(rgb);
    east += hsi.saturation * std::cos(hsi.hue_rad);
    north += hsi.saturation * std::sin(hsi.hue_rad);
    fit.key.saturation += hsi.saturation / n;
    fit.key.intensity += hsi.intensity / n;
  }
  fit.key.hue_rad = east == 0.0 && north == 0.0 ? 0.0 : std::atan2(north, east);
  double hue = 0.0, weight = 0.0, saturation = 0.0, intensity = 0.0;
  for (const Rgb& rgb : samples) {
    const Hsi hsi = hsi_of(rgb);
    hue += hsi.saturation * std::pow(angle_between(fit.key.hue_rad, hsi.hue_rad), 2);
    weight += hsi.saturation;
    saturation += std::pow(hsi.saturation - fit.key.saturation, 2) / n;
    intensity += std::pow(hsi.intensity - fit.key.intensity, 2) / n;
  }
  fit.hue_deviation_rad = std::max(weight > 0.0 ? std::sqrt(hue / weight) : 0.0, 0.05);
  fit.saturation_deviation = std::max(std::sqrt(saturation), 0.03);
  fit.intensity_deviation = std::max(std::sqrt(intensity), 0.05);
  return fit;
}

HandColourTable::HandColourTable(const HandColour& hand) : on_(64U * 64U * 64U) {
  for (std::size_t i = 0; i < on_.size(); ++i) {
    const auto level = [&](unsigned shift) { return static_cast<std::uint8_t>((i >> shift & 63U) << 2U | 2U); };
    on_[i] = mahalanobis(hand, hsi_of({level(12), level(6), level(0)})) <= hand.threshold ? 1 : 0;
  }
}

}  // namespace telepalp::mixed
