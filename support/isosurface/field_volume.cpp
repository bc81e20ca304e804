#include "support/isosurface/field_volume.h"

#include <cmath>
#include <random>

namespace telepalp::isosurface {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::size_t kMostBoxes = 200'000;
constexpr int kPoints = 8;
constexpr double kExact = 0.002;  // a standard error below this share of the volume suffices

struct Boxes {
  double inside_m3 = 0.0;
  std::vector<AlignedBox3d> at_surface;
};

/// Halves the boxes at the surface along their longest sides.
Boxes halved(const Field& field, Boxes boxes) {
  std::vector<AlignedBox3d> kept;
  for (const AlignedBox3d& box : boxes.at_surface) {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    for (int half = 0; half < 2; ++half) {
      AlignedBox3d part = box;
      (half == 0 ? part.max() : part.min())[axis] = box.center()[axis];
      const double m = field.m_at(part.center());
      if (std::abs(m) <= 0.5 * field.steepest * part.diagonal().norm())
        kept.push_back(part);
      else if (m < 0.0)
        boxes.inside_m3 += part.volume();
    }
  }
  boxes.at_surface = std::move(kept);
  return boxes;
}

Volume sampled(const Field& field, const Boxes& boxes) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Volume volume{.m3 = boxes.inside_m3, .error_m3 = 0.0};
  double variance = 0.0;
  for (const AlignedBox3d& box : boxes.at_surface) {
    int inside = 0;
    for (int i = 0; i < kPoints; ++i) {
      const Vector3d at(share(random), share(random), share(random));
      inside += field.m_at(box.min() + at.cwiseProduct(box.sizes())) < 0.0 ? 1 : 0;
    }
    const double part = static_cast<double>(inside) / kPoints;
    volume.m3 += part * box.volume();
    variance += part * (1.0 - part) / (kPoints - 1) * box.volume() * box.volume();
  }
  volume.error_m3 = std::sqrt(variance);
  return volume;
}

}  // namespace

Volume volume_of(const Field& field, const AlignedBox3d& box) {
  Boxes boxes{.inside_m3 = 0.0, .at_surface = {box}};
  Volume volume;
  for (int round = 1; !boxes.at_surface.empty() && boxes.at_surface.size() < kMostBoxes && round < 60; ++round) {
    boxes = halved(field, std::move(boxes));
    if (round % 3 != 0 || round < 12) continue;
    volume = sampled(field, boxes);
    if (volume.error_m3 <= kExact * volume.m3) return volume;
  }
  return sampled(field, boxes);
}

}  // namespace telepalp::isosurface
