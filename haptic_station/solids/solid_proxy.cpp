#include "haptic_station/solids/solid_proxy.h"

#include <algorithm>
#include <cmath>

namespace telepalp::solids {

using Eigen::Vector3d;

SolidAt SolidProxy::value(const SolidTree& tree, double swell_m) noexcept {
  SolidAt at = settings_.remembers ? near_.at(tree, proxy_) : solid_at(tree, proxy_);
  at.m -= swell_m;
  return at;
}

Walls SolidProxy::walls(const SolidTree& tree, double swell_m) noexcept {
  return settings_.remembers ? near_.walls(tree, proxy_, swell_m) : walls_at(tree, proxy_, swell_m);
}

/// Starts the proxy at the device. From inside the solid it moves out along the gradient, which is exact for one shape.
void SolidProxy::start(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  started_ = true;
  proxy_ = device;
  for (int i = 0; i < settings_.rounds; ++i) {
    const SolidAt at = value(tree, swell_m);
    if (at.m >= -settings_.tolerance_m || at.gradient.squaredNorm() < Walls::kShortest * Walls::kShortest) return;
    proxy_ -= (at.m - settings_.tolerance_m) / at.gradient.squaredNorm() * at.gradient;
  }
}

/// Moves the proxy towards the device until the solid stops it. Each step is at most the distance to the surface.
/// Returns false when the solid stopped the proxy.
bool SolidProxy::sweep(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  for (int i = 0; i < kMostSweeps; ++i) {
    const Vector3d way = device - proxy_;
    const double left_m = way.norm();
    const SolidAt at = value(tree, swell_m);
    if (!std::isfinite(at.m) || left_m * tree.steepest < at.m) {
      proxy_ = device;
      return true;
    }
    if (at.m <= settings_.tolerance_m) {
      if (stopped(tree, way, swell_m)) return false;
      proxy_ += std::min(left_m, Walls::kNear_m) / std::max(left_m, settings_.tolerance_m) * way;  // away from the wall
      if (left_m <= Walls::kNear_m) return value(tree, swell_m).m >= 0.0;
      continue;
    }
    proxy_ += std::min(1.0, at.m / (tree.steepest * left_m)) * way;
  }
  return false;
}

/// True if a wall at the proxy faces the way; then the walls hold the proxy.
bool SolidProxy::stopped(const SolidTree& tree, const Vector3d& way, double swell_m) noexcept {
  walls_ = walls(tree, swell_m);
  for (const HalfSpace& wall : walls_.spaces())
    if (wall.normal.dot(proxy_) - wall.offset_m <= settings_.tolerance_m && wall.normal.dot(way) < 0.0) {
      push_out(proxy_);
      return true;
    }
  walls_ = {};
  return false;
}

/// Moves a proxy that is inside the solid out of it.
void SolidProxy::push_out(const Vector3d& otherwise) noexcept {
  if (walls_.least_m < 0.0) proxy_ = nearest_in(walls_.spaces(), proxy_, otherwise);
}

/// Moves the proxy along the walls to the point nearest to the device. A step is at most Walls::kNear_m, the distance
/// within which walls are known.
void SolidProxy::slide(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  for (int i = 0; i < settings_.rounds; ++i) {
    const Vector3d before = proxy_;
    const Vector3d way = nearest_in(walls_.spaces(), device, proxy_) - proxy_;
    const double length = way.norm();
    proxy_ += length > Walls::kNear_m ? Vector3d(Walls::kNear_m / length * way) : way;
    const Walls next = walls(tree, swell_m);
    if (next.count == 0 && next.least_m < 0.0) {  // between opposite sides of a mesh: the last walls stay
      proxy_ = before;
      break;
    }
    walls_ = next;
    push_out(before);
    if ((proxy_ - before).norm() < 0.01 * settings_.tolerance_m) break;
  }
}

ProxyAt SolidProxy::step(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  if (!device.allFinite()) return {proxy_, Vector3d::Zero(), 0.0};
  if (!started_) start(tree, device, swell_m);
  if (walls_.count == 0 && sweep(tree, device, swell_m)) return {device, Vector3d::Zero(), 0.0};
  slide(tree, device, swell_m);
  const Vector3d pull = proxy_ - device;
  const double depth_m = pull.norm();
  if (depth_m <= settings_.tolerance_m) {
    walls_ = {};
    return {device, Vector3d::Zero(), 0.0};
  }
  if (depth_m > kTorn_m && solid_at(tree, device).m - swell_m > settings_.tolerance_m) {
    proxy_ = device;
    walls_ = {};
    return {device, Vector3d::Zero(), 0.0};
  }
  return {proxy_, pull / depth_m, depth_m};
}

}  // namespace telepalp::solids
