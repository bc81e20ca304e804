#include "clients/mixed/scene/ray_bodies.h"

#include <algorithm>
#include <cmath>

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;

bool meets_ball(const Ray& ray, const Vector3d& centre, double radius, Hit& nearest) {
  const Vector3d from = ray.from - centre;
  const double a = ray.to.squaredNorm(), b = from.dot(ray.to), c = from.squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0.0) return false;
  const double along = (-b - std::sqrt(root)) / a;
  if (along <= 0.0 || along >= nearest.along) return false;
  nearest = {along, (from + along * ray.to) / radius};
  return true;
}

}  // namespace

Body Body::box(const Eigen::Isometry3d& world_from_box, const Vector3d& half_m) {
  Body body;
  body.body_from_world_ = world_from_box.inverse();
  body.half_m_ = half_m;
  body.middle_ = world_from_box.translation();
  body.around_m_ = half_m.norm();
  return body;
}

Body Body::cone(const Vector3d& from, const Vector3d& to, double from_radius_m, double to_radius_m) {
  Body body;
  body.kind_ = Kind::Cone;
  const Vector3d axis = to - from;
  body.length_m_ = axis.norm();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis);
  body.body_from_world_ = Eigen::Isometry3d(Eigen::Translation3d(from) * turn).inverse();
  body.from_radius_m_ = from_radius_m;
  body.to_radius_m_ = to_radius_m;
  body.middle_ = 0.5 * (from + to);
  body.around_m_ = 0.5 * body.length_m_ + std::max(from_radius_m, to_radius_m);
  return body;
}

Body Body::capsule(const Vector3d& from, const Vector3d& to, double from_radius_m, double to_radius_m) {
  Body body = cone(from, to, from_radius_m, to_radius_m);
  body.kind_ = Kind::Capsule;
  return body;
}

bool Body::meets(const Ray& ray, Hit& nearest) const {
  Hit around;
  const bool inside = (ray.from - middle_).norm() <= around_m_;
  if (!inside && !meets_ball(ray, middle_, around_m_, around)) return false;
  if (!inside && around.along >= nearest.along) return false;
  const Ray local{body_from_world_ * ray.from, body_from_world_.linear() * ray.to};
  Hit hit = nearest;
  bool met = false;
  if (kind_ == Kind::Box) {
    met = meets_box(local, hit);
  } else {
    met = meets_side(local, hit);
    const Vector3d end(0.0, 0.0, length_m_);
    if (kind_ == Kind::Capsule) {
      met = meets_ball(local, Vector3d::Zero(), from_radius_m_, hit) || met;
      met = meets_ball(local, end, to_radius_m_, hit) || met;
    } else {
      met = meets_disc(local, 0.0, from_radius_m_, hit) || met;
      met = meets_disc(local, length_m_, to_radius_m_, hit) || met;
    }
  }
  if (!met) return false;
  nearest = {hit.along, body_from_world_.linear().transpose() * hit.normal};
  return true;
}

bool Body::meets_box(const Ray& ray, Hit& nearest) const {
  double enter = 0.0, leave = nearest.along;
  int face = -1;
  for (int i = 0; i < 3; ++i) {
    if (ray.to[i] == 0.0) {
      if (std::abs(ray.from[i]) > half_m_[i]) return false;
      continue;
    }
    const double one = (-half_m_[i] - ray.from[i]) / ray.to[i], other = (half_m_[i] - ray.from[i]) / ray.to[i];
    if (std::min(one, other) > enter) {
      enter = std::min(one, other);
      face = i;
    }
    leave = std::min(leave, std::max(one, other));
    if (enter > leave) return false;
  }
  if (face < 0 || enter >= nearest.along) return false;
  nearest = {enter, -std::copysign(1.0, ray.to[face]) * Vector3d::Unit(face)};
  return true;
}

/// The side of a cone around z: x² + y² = (from_radius_m_ + k z)² between z = 0 and length_m_.
bool Body::meets_side(const Ray& ray, Hit& nearest) const {
  const double k = (to_radius_m_ - from_radius_m_) / length_m_;
  const double radius = from_radius_m_ + k * ray.from.z();
  const double a = ray.to.head<2>().squaredNorm() - k * k * ray.to.z() * ray.to.z();
  const double b = ray.from.head<2>().dot(ray.to.head<2>()) - k * radius * ray.to.z();
  const double c = ray.from.head<2>().squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0.0 || a == 0.0) return false;
  for (const double sign : {-1.0, 1.0}) {
    const double along = (-b + sign * std::sqrt(root)) / a;
    const Vector3d at = ray.from + along * ray.to;
    if (along <= 0.0 || along >= nearest.along || at.z() < 0.0 || at.z() > length_m_) continue;
    nearest = {along, Vector3d(at.x(), at.y(), -k * (from_radius_m_ + k * at.z())).normalized()};
    return true;
  }
  return false;
}

bool Body::meets_disc(const Ray& ray, double at, double radius, Hit& nearest) const {
  const double along = (at - ray.from.z()) / ray.to.z();
  if (!(along > 0.0) || along >= nearest.along) return false;
  if ((ray.from + along * ray.to).head<2>().norm() > radius) return false;
  nearest = {along, Vector3d(0.0, 0.0, at > 0.0 ? 1.0 : -1.0)};
  return true;
}

}  // namespace telepalp::mixed
