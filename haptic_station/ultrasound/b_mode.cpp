#include "haptic_station/ultrasound/b_mode.h"

#include <algorithm>
#include <cmath>

namespace telepalp::ultrasound {
namespace {

constexpr double kRange_dB = 60.0;      // dynamic range: difference of echo level between black and white
constexpr double kSpecularPower = 4.0;  // a boundary's echo is proportional to cos(incidence) to this power

using effects::Echo;
using Eigen::Vector3d;

constexpr double kSpeckle_m = 0.0006;  // size of a speckle grain
constexpr double kSpeckle_dB = -35.0;  // mean level at full scatter, relative to the echo of a perfect mirror
constexpr std::size_t kTissue = static_cast<std::size_t>(-1);

/// A well-mixed 64-bit hash (the finaliser of splitmix64).
std::uint64_t mixed(std::uint64_t x) noexcept {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Speckle in dB at a place of the body: the amplitude of many random scatterers in a grain has Rayleigh's law.
double speckle_dB(const Vector3d& p) noexcept {
  const auto cell = [](double m) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(m / kSpeckle_m)));
  };
  const std::uint64_t hash = mixed(cell(p.x()) * 0x9e3779b97f4a7c15ULL ^ mixed(cell(p.y()) ^ mixed(cell(p.z()))));
  const double uniform = (static_cast<double>(hash >> 11) + 1.0) * 0x1.0p-53;
  return 10.0 * std::log10(-std::log(uniform) + 1e-3);
}

/// Whether a scan line is inside a layer: known up to the depth `known_to_m`.
struct Crossing {
  double known_to_m = -1.0;
  bool inside = false;
  Vector3d gradient = Vector3d::Zero();
};

/// One scan line, from the skin down.
class ScanLine {
 public:
  ScanLine(std::span<const PlacedLayer> layers, const Vector3d& tissue_moved_m, std::vector<Crossing>& crossings,
           const BModeSettings& settings) noexcept
      : layers_(layers), tissue_moved_m_(tissue_moved_m), crossings_(crossings), settings_(settings) {
    std::fill(crossings_.begin(), crossings_.end(), Crossing{});
  }

  /// Brightness in dB at the next depth.
  [[nodiscard]] double next_dB(const Vector3d& p, const Vector3d& along, double depth_m, double step_m) {
    const std::size_t now = filled_by(p, depth_m, step_m);
    const double echo_dB = started_ && now != last_ ? boundary_dB(now, along) : -1e3;
    last_ = now;
    started_ = true;
    const Echo& tissue = of(now);
    sent_dB_ -= 2.0 * 100.0 * step_m * (tissue.attenuation_dB_per_cm - settings_.tissue.attenuation_dB_per_cm);
    const Vector3d grain = p - (now == kTissue ? tissue_moved_m_ : layers_[now].moved_m);
    const double grain_dB =
        tissue.scatter > 0.0 ? kSpeckle_dB + 20.0 * std::log10(tissue.scatter) + speckle_dB(grain) : -1e3;
    return std::max(echo_dB, sent_dB_ + grain_dB);
  }

 private:
  [[nodiscard]] const Echo& of(std::size_t layer) const noexcept {
    return layer == kTissue ? settings_.tissue : layers_[layer].layer->echo;
  }

  /// The last layer that contains the point. A layer's distance is evaluated anew only beyond Crossing::known_to_m.
  [[nodiscard]] std::size_t filled_by(const Vector3d& p, double depth_m, double step_m) {
    std::size_t fills = kTissue;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      Crossing& crossing = crossings_[i];
      if (depth_m > crossing.known_to_m) {
        const solids::SolidTree& tree = *layers_[i].layer->tree;
        const solids::SolidAt at = solids::solid_at(tree, p - layers_[i].moved_m);
        crossing = {depth_m + std::max(0.5 * step_m, std::abs(at.m) / tree.steepest), at.m < 0.0, at.gradient};
      }
      if (crossing.inside) fills = i;
    }
    return fills;
  }

  /// Echo level of the boundary between the layers `last_` and `now`.
  [[nodiscard]] double boundary_dB(std::size_t now, const Vector3d& along) {
    const double z1 = of(last_).impedance_MRayl;
    const double z2 = of(now).impedance_MRayl;
    const double reflected = std::pow((z2 - z1) / (z2 + z1), 2.0);
    const Vector3d& normal = crossings_[now != kTissue ? now : last_].gradient;
    const double cosine = std::min(1.0, std::abs(normal.dot(along)));
    const double echo_dB = 10.0 * std::log10(reflected * std::pow(cosine, kSpecularPower) + 1e-12);
    const double before_dB = sent_dB_;                      // the boundary's echo does not cross the boundary
    sent_dB_ += 20.0 * std::log10(1.0 - reflected + 1e-6);  // both ways through the boundary
    return before_dB + echo_dB;
  }

  std::span<const PlacedLayer> layers_;
  Vector3d tissue_moved_m_;
  std::vector<Crossing>& crossings_;
  const BModeSettings& settings_;
  double sent_dB_ = 0.0;
  std::size_t last_ = kTissue;
  bool started_ = false;
};

}  // namespace

BModeImage b_mode(std::span<const std::shared_ptr<const effects::SolidLayer>> layers, const ProbePose& probe,
                  const BModeSettings& settings) {
  std::vector<PlacedLayer> placed;
  for (const auto& layer : layers) placed.push_back({.layer = layer.get()});
  return b_mode(placed, probe, settings);
}

BModeImage b_mode(std::span<const PlacedLayer> layers, const ProbePose& probe, const BModeSettings& settings) {
  Vector3d tissue_moved_m = Vector3d::Zero();
  for (const PlacedLayer& layer : layers) tissue_moved_m += layer.moved_m / static_cast<double>(layers.size());
  const auto side = static_cast<std::size_t>(settings.side_px);
  BModeImage image{.side_px = settings.side_px, .gray = std::vector<std::uint8_t>(side * side)};
  std::vector<Crossing> crossings(layers.size());
  const double step_m = settings.depth_m / settings.side_px;
  for (std::size_t u = 0; u < side; ++u) {
    const double x_m = ((static_cast<double>(u) + 0.5) / settings.side_px - 0.5) * settings.width_m;
    ScanLine line(layers, tissue_moved_m, crossings, settings);
    for (std::size_t v = 0; v < side; ++v) {
      const double depth_m = (static_cast<double>(v) + 0.5) * step_m;
      const Vector3d p = probe.at + x_m * probe.across + depth_m * probe.into_body;
      const double dB = line.next_dB(p, probe.into_body, depth_m, step_m);
      image.gray[v * side + u] =
          static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(1.0 + dB / kRange_dB, 0.0, 1.0)));
    }
  }
  return image;
}

}  // namespace telepalp::ultrasound
