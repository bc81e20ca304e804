#include "haptic_station/station/bill/seen_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::station {
namespace {

using Eigen::Vector3d;

constexpr double kTop_m = 0.80;    // depth of the highest skin
constexpr double kHalf_m = 0.20;   // half of the trunk's width
constexpr double kThick_m = 0.20;  // height of the trunk over the table
constexpr double kTable_m = kTop_m + kThick_m;
constexpr double kRests_s = 1.0;
constexpr double kRise_m = 0.005;
constexpr double kStep_m = 1e-6;  // of numerical derivatives

double smooth(double s) noexcept { return s * s * (3.0 - 2.0 * s); }

/// Height of the skin over full exhale, 0 to about 1, where the belly moves most.
double breath(double time_s) noexcept {
  double from_s = kRests_s;
  for (int i = 0; time_s > from_s; ++i) {
    const double period_s = 3.6 * (1.0 + 0.15 * std::sin(1.7 * i));
    const double high = 1.0 + 0.2 * std::sin(2.9 * i + 0.5);
    const double share = (time_s - from_s) / period_s;
    if (share < 0.4) return high * smooth(share / 0.4);
    if (share < 1.0) return high * (1.0 - smooth((share - 0.4) / 0.6));
    from_s += period_s;
  }
  return 0.0;
}

/// Depth of the resting skin: an elliptic trunk with chest, belly and navel on a table.
double rest_z_m(double x_m, double y_m) noexcept {
  const double across = x_m / kHalf_m;
  const double around = 1.0 - across * across;
  if (around <= 0.0) return kTable_m;
  const double long_m = 0.010 * std::sin(2.0 * std::numbers::pi * y_m / 0.45 + 0.6);
  const double navel_m = 0.006 * std::exp(-(x_m * x_m + (y_m - 0.11) * (y_m - 0.11)) / (2.0 * 0.012 * 0.012));
  return std::min(kTable_m, kTop_m + kThick_m * (1.0 - std::sqrt(around)) + (long_m + 0.010) * around + navel_m);
}

/// Depth at which the ray (u, v, 1) z meets the resting skin, by bisection.
double met_z_m(double u, double v) noexcept {
  double before = kTop_m - 0.05;
  double behind = kTable_m;
  for (int i = 0; i < 20; ++i) {
    const double z = 0.5 * (before + behind);
    (z < rest_z_m(u * z, v * z) ? before : behind) = z;
  }
  return 0.5 * (before + behind);
}

double share_at(double y_m) noexcept { return std::exp(-(y_m - 0.05) * (y_m - 0.05) / (2.0 * 0.2 * 0.2)); }

}  // namespace

SeenBody::SeenBody() : sensor_(sensor::DepthSensorSettings{}) {
  pixels_.resize(static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height));
  for (int row = 0; row < camera_.height; ++row)
    for (int column = 0; column < camera_.width; ++column) {
      const double u = (column - camera_.cx) / camera_.fx;
      const double v = (row - camera_.cy) / camera_.fy;
      const double z = met_z_m(u, v);
      const double dx = (rest_z_m(u * z + kStep_m, v * z) - rest_z_m(u * z - kStep_m, v * z)) / (2.0 * kStep_m);
      const double dy = (rest_z_m(u * z, v * z + kStep_m) - rest_z_m(u * z, v * z - kStep_m)) / (2.0 * kStep_m);
      const bool table = z > kTable_m - 1e-6;
      pixels_[static_cast<std::size_t>(row * camera_.width + column)] = {
          .z_m = static_cast<float>(z),
          .per_risen = table ? 0.0F : static_cast<float>(-share_at(v * z) / std::max(0.2, 1.0 - dx * u - dy * v))};
    }
}

double SeenBody::risen_m(double y_m, double time_s) const noexcept { return kRise_m * breath(time_s) * share_at(y_m); }

double SeenBody::z_m(double x_m, double y_m, double time_s) const noexcept {
  const double rest_m = rest_z_m(x_m, y_m);
  return rest_m < kTable_m ? rest_m - risen_m(y_m, time_s) : rest_m;
}

DepthImage SeenBody::depth_at(double time_s) const {
  DepthImage depth{
      .width = camera_.width, .height = camera_.height, .unit_m = sensor_.settings().unit_m, .samples = {}};
  depth.samples.resize(pixels_.size());
  const sensor::Exposure exposure = sensor_.expose(std::llround(time_s * 1e9));
  const auto risen_m = static_cast<float>(kRise_m * breath(time_s));
  for (std::size_t i = 0; i < pixels_.size(); ++i)
    depth.samples[i] = exposure.sample(pixels_[i].z_m + risen_m * pixels_[i].per_risen, static_cast<std::uint32_t>(i));
  return depth;
}

TrueBody::TrueBody(const SeenBody& body, double time_s, SessionTime at) noexcept : body_(body), time_s_(time_s) {
  captured = at;
  points = 1;
  motion.moves = false;
}

surface::FieldSample TrueBody::evaluate(const Vector3d& query, const Vector3d&,
                                        const surface::MotionBasis&) const noexcept {
  const double x = query.x();
  const double y = query.y();
  const auto z = [&](double dx, double dy, double dt) { return body_.z_m(x + dx, y + dy, time_s_ + dt); };
  const Vector3d down(-(z(kStep_m, 0, 0) - z(-kStep_m, 0, 0)) / (2.0 * kStep_m),
                      -(z(0, kStep_m, 0) - z(0, -kStep_m, 0)) / (2.0 * kStep_m), 1.0);
  surface::FieldSample sample;
  sample.valid = true;
  sample.normal = -down.normalized();
  sample.gradient = sample.normal;
  sample.f_m = (z(0, 0, 0) - query.z()) / down.norm();
  sample.coverage = 1.0;
  sample.velocity_m_per_s = sample.normal.z() * (z(0, 0, 1e-4) - z(0, 0, -1e-4)) / 2e-4;
  return sample;
}

std::optional<surface::Seed> TrueBody::seed(const Vector3d& query) const noexcept {
  const double z = body_.z_m(query.x(), query.y(), time_s_);
  return surface::Seed{.at = {query.x(), query.y(), z}, .query_in_front = query.z() < z};
}

}  // namespace telepalp::station
