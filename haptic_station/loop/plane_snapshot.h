#pragma once

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::loop {

/// The tangent plane of a surface at one point, as a surface snapshot. A collision detection that is too slow for the 2
/// kHz haptic thread runs on another thread and hands this plane over. Paper S1 (II.C and II.D, docs/sources.md)
/// likewise finds the proxy at 100 Hz and uses it at 2 kHz.
class PlaneSnapshot final : public surface::SurfaceSnapshot {
 public:
  /// A snapshot without a surface: no skin is in reach.
  PlaneSnapshot() = default;
  /// The plane through the surface point `foot`, with the unit `normal` out of the body, in the depth camera's frame.
  /// `coverage`: 1 well inside the known surface, 0 at its rim.
  PlaneSnapshot(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal, double coverage) noexcept
      : foot_(foot), normal_(normal), coverage_(coverage), known_(true) {}

  [[nodiscard]] surface::FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d&,
                                              const surface::MotionBasis&) const noexcept override {
    surface::FieldSample sample;
    if (!known_) return sample;
    sample.valid = true;
    sample.f_m = normal_.dot(query - foot_);
    sample.gradient = normal_;
    sample.normal = normal_;
    sample.coverage = coverage_;
    return sample;
  }
  [[nodiscard]] std::optional<surface::Seed> seed(const Eigen::Vector3d& query) const noexcept override {
    if (!known_) return std::nullopt;
    const double height = normal_.dot(query - foot_);
    return surface::Seed{.at = query - height * normal_, .query_in_front = height >= 0.0};
  }
  [[nodiscard]] double stride_m(const Eigen::Vector3d&) const noexcept override { return kStride_m; }

 private:
  static constexpr double kStride_m = 0.05;  // any finite value: the plane is exact at every distance
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  double coverage_ = 0.0;
  bool known_ = false;
};

}  // namespace telepalp::loop
