#include "haptic_station/solids/solid_proxy.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/solids/proxy/half_spaces.h"

namespace telepalp::solids {

using Eigen::Vector3d;

SolidAt SolidProxy::swollen_at(const SolidTree& tree, const Vector3d& p, double swell_m) noexcept {
  SolidAt at = settings_.remembers ? near_.at(tree, p) : solid_at(tree, p);
  at.m -= swell_m;
  return at;
}

/// Starts the proxy at the device. From inside the solid it moves out along the gradient, which is exact for one shape.
void SolidProxy::start(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  started_ = true;
  proxy_ = device;
  for (int i = 0; i < settings_.rounds; ++i) {
    const SolidAt at = swollen_at(tree, proxy_, swell_m);
    if (at.m >= -settings_.tolerance_m || at.gradient.squaredNorm() < kFlat * kFlat) return;
    proxy_ -= (at.m - settings_.tolerance_m) / at.gradient.squaredNorm() * at.gradient;
  }
}

/// Moves the proxy towards the device until the solid stops it. Each step is at most the distance to the surface.
/// Returns false when the solid stopped the proxy.
bool SolidProxy::sweep(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  for (int i = 0; i < kMostSweeps; ++i) {
    const Vector3d way = device - proxy_;
    const double left_m = way.norm();
    const SolidAt at = swollen_at(tree, proxy_, swell_m);
    if (!std::isfinite(at.m) || left_m * tree.steepest < at.m) {
      proxy_ = device;
      return true;
    }
    if (at.m <= settings_.tolerance_m) {
      if (at.gradient.dot(way) < 0.0) return !hold(at);
      proxy_ += std::min(left_m, kStride_m) / std::max(left_m, settings_.tolerance_m) * way;  // away from the surface
      if (left_m <= kStride_m) return swollen_at(tree, proxy_, swell_m).m >= 0.0;
      continue;
    }
    proxy_ += std::min(1.0, at.m / (tree.steepest * left_m)) * way;
  }
  return false;
}

/// Adds or renews the plane of the part that gives the value at the proxy. Moves a proxy that is inside the solid onto
/// this plane. Returns false if opposite sides are equally near: then there is no plane, and the last planes stay.
bool SolidProxy::hold(const SolidAt& at) noexcept {
  const double length = at.gradient.norm();
  if (length < kFlat) return false;
  const Vector3d normal = at.gradient / length;
  const Vector3d on = proxy_ - at.m / length * normal;
  std::size_t place = 0;
  while (place < count_ && planes_[place].part != at.part) ++place;
  if (place == planes_.size()) place = 0;
  if (place == count_) ++count_;
  planes_[place] = {on, normal, at.part};
  if (at.m < 0.0) proxy_ = on;
  return true;
}

/// Drops the planes that do not hold the proxy back.
void SolidProxy::let_go(const Vector3d& device) noexcept {
  const Vector3d at = goal(device);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i)
    if (planes_[i].normal.dot(at - planes_[i].at) <= settings_.tolerance_m) planes_[kept++] = planes_[i];
  count_ = kept;
}

Vector3d SolidProxy::goal(const Vector3d& device) const noexcept {
  std::array<HalfSpace, 3> spaces;
  for (std::size_t i = 0; i < count_; ++i) spaces[i] = {planes_[i].normal, planes_[i].normal.dot(planes_[i].at)};
  return nearest_in({spaces.data(), count_}, device, proxy_);
}

/// Moves the proxy along the surface to the point nearest to the device.
void SolidProxy::slide(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  for (int i = 0; i < settings_.rounds; ++i) {
    const Vector3d before = proxy_;
    const Vector3d way = goal(device) - proxy_;
    const double length = way.norm();
    proxy_ += length > kStride_m ? Vector3d(kStride_m / length * way) : way;
    const SolidAt at = swollen_at(tree, proxy_, swell_m);
    const bool near = at.m <= kStride_m;
    if (near && !hold(at) && at.m < 0.0) proxy_ = before;
    if ((proxy_ - before).norm() < 0.01 * settings_.tolerance_m) break;
  }
  let_go(device);
}

ProxyAt SolidProxy::step(const SolidTree& tree, const Vector3d& device, double swell_m) noexcept {
  if (!device.allFinite()) return {proxy_, Vector3d::Zero(), 0.0};
  if (!started_) start(tree, device, swell_m);
  if (count_ == 0 && sweep(tree, device, swell_m)) return {device, Vector3d::Zero(), 0.0};
  slide(tree, device, swell_m);
  const Vector3d pull = proxy_ - device;
  const double depth_m = pull.norm();
  if (depth_m <= settings_.tolerance_m) return {device, Vector3d::Zero(), 0.0};
  if (depth_m > kTorn_m && solid_at(tree, device).m - swell_m > settings_.tolerance_m) {
    proxy_ = device;
    count_ = 0;
    return {device, Vector3d::Zero(), 0.0};
  }
  return {proxy_, pull / depth_m, depth_m};
}

}  // namespace telepalp::solids
