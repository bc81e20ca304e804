#pragma once

#include <Eigen/Geometry>

namespace telepalp::mixed {

struct Ray {
  Eigen::Vector3d from;
  Eigen::Vector3d to;  ///< direction, of any length
};

struct Hit {
  double along = 1e9;                                ///< distance on the ray, in lengths of Ray::to
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the body's surface, unit
};

/// A solid that rays meet: a box, a truncated cone, or the round hull of two balls (a capsule, drawn as a truncated
/// cone with balls at its ends).
class Body {
 public:
  [[nodiscard]] static Body box(const Eigen::Isometry3d& world_from_box, const Eigen::Vector3d& half_m);
  [[nodiscard]] static Body cone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double from_radius_m,
                                 double to_radius_m);
  [[nodiscard]] static Body capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double from_radius_m,
                                    double to_radius_m);

  /// True if the ray meets the body before `nearest`, which it then replaces.
  bool meets(const Ray& ray, Hit& nearest) const;

 private:
  enum class Kind { Box, Cone, Capsule };
  bool meets_box(const Ray& ray, Hit& nearest) const;
  bool meets_side(const Ray& ray, Hit& nearest) const;
  bool meets_disc(const Ray& ray, double at, double radius, Hit& nearest) const;

  Kind kind_ = Kind::Box;
  Eigen::Isometry3d body_from_world_ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half_m_ = Eigen::Vector3d::Zero();
  double length_m_ = 0.0, from_radius_m_ = 0.0, to_radius_m_ = 0.0;  ///< of cone and capsule, along z from 0
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  ///< centre of a ball around the body, in the world's frame
  double around_m_ = 0.0;                             ///< radius of the ball around the body
};

}  // namespace telepalp::mixed
