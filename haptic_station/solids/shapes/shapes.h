#pragma once

#include <Eigen/Core>

#include "haptic_station/solids/distance_lattice.h"

namespace telepalp::solids {

// Signed distances of shapes [m], negative inside, with exact gradients, in the shape's own frame; most shapes are
// centred at the frame's origin. The gradient has length 1; where several surface points are equally near, a fixed rule
// chooses one of them. Each distance is 1-Lipschitz. Exception to length 1 and to 1-Lipschitz: mesh_at(). No
// function allocates or throws. "Exact" means: the value is the true distance to the surface, inside and outside.

/// Signed distance [m] and its gradient, which points outwards.
struct ShapeAt {
  double m;
  Eigen::Vector3d gradient;
};

/// Exact. At the centre the gradient is +y.
[[nodiscard]] ShapeAt sphere_at(const Eigen::Vector3d& p, double radius_m) noexcept;

/// Exact; inside where normal . p < offset. `normal`: unit.
[[nodiscard]] ShapeAt plane_at(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double offset_m) noexcept;

/// Exact. A segment of length zero gives a sphere. On the segment the gradient is perpendicular to the segment.
[[nodiscard]] ShapeAt capsule_at(const Eigen::Vector3d& p, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double radius_m) noexcept;

/// A torus about the axis x, y or z (0, 1, 2). Exact. `ring_m`, `tube_m`: radii. If the tube's radius exceeds the
/// ring's, the shape is the union of all balls centred on the ring, and its outer surface counts. On the axis, the
/// ring's point towards the next axis (y for x) counts; at a tube's centre the gradient points away from the axis.
[[nodiscard]] ShapeAt torus_at(const Eigen::Vector3d& p, int axis, double ring_m, double tube_m) noexcept;

/// Part of a torus, with round ends. Angles go from the next axis to the one after it (for axis x, from y to z).
/// `half_sweep_rad`: 0 to pi. arc_at() is exact outside; inside too if the tube is narrower than the ring.
struct ArcSpan {
  double middle_rad;
  double half_sweep_rad;
};
[[nodiscard]] ShapeAt arc_at(const Eigen::Vector3d& p, int axis, double ring_m, double tube_m, ArcSpan span) noexcept;

/// Exact. Inside, the gradient is the normal of the nearest face: at a tie the first of x, y, z, and between opposite
/// faces the positive one.
[[nodiscard]] ShapeAt box_at(const Eigen::Vector3d& p, const Eigen::Vector3d& half_m) noexcept;

/// Exact to 1e-12 of the largest radius, by Newton's method on the distance's secular equation (Eberly 2013).
[[nodiscard]] ShapeAt ellipsoid_at(const Eigen::Vector3d& p, const Eigen::Vector3d& radii_m) noexcept;

/// A cylinder about the axis x, y or z (0, 1, 2). Exact.
[[nodiscard]] ShapeAt cylinder_at(const Eigen::Vector3d& p, int axis, double radius_m, double half_length_m) noexcept;

/// The distance to a closed mesh: the spline of distance_at(), which is defined on a box, one node spacing inside the
/// lattice's border. Outside this box the value is sqrt(gap^2 + d^2), with gap the distance to the nearest point of the
/// box and d the spline's value at that point. It is continuous, and no more than the true distance if d is not,
/// because the mesh lies inside the box. Not 1-Lipschitz where the spline is not: its slope is at most sqrt(3).
[[nodiscard]] ShapeAt mesh_at(const Eigen::Vector3d& p, const DistanceLattice& lattice) noexcept;

}  // namespace telepalp::solids
