#pragma once

#include <Eigen/Core>

#include "haptic_station/solids/distance_lattice.h"

namespace telepalp::solids {

// Signed distances of shapes in their own frame, most of them centred at its origin, each with its exact gradient:
// negative inside, in metres. The gradient has length 1, also where the nearest point of the surface is not unique:
// there a fixed rule chooses one of the nearest. Each distance is 1-Lipschitz. Exception: mesh_at, see there. No
// function allocates or throws. "Exact" means: the value is the true distance to the surface, on both sides of it.

/// Distance and outward direction.
struct ShapeAt {
  double m;
  Eigen::Vector3d gradient;
};

/// Exact. At the centre the gradient is +y.
[[nodiscard]] ShapeAt sphere_at(const Eigen::Vector3d& p, double radius_m) noexcept;

/// Exact; inside where normal . p < offset. `normal`: unit.
[[nodiscard]] ShapeAt plane_at(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double offset_m) noexcept;

/// Exact. A segment of length zero is a sphere. On the segment the gradient is perpendicular to it.
[[nodiscard]] ShapeAt capsule_at(const Eigen::Vector3d& p, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                 double radius_m) noexcept;

/// A torus about the axis x, y or z (0, 1, 2). Exact. If the tube's radius exceeds the ring's, the shape is the union
/// of all balls centred on the ring, and the distance is that to its outer surface. On the axis, the part of the ring
/// towards the next axis (y for x) counts as the nearest; at a tube's centre the gradient points away from the axis.
[[nodiscard]] ShapeAt torus_at(const Eigen::Vector3d& p, int axis, double ring_m, double tube_m) noexcept;

/// A part of a torus with round ends. Angles are counted from the next axis (y for x) towards the one after it.
/// Exact outside; inside too while the tube is narrower than the ring. `half_sweep_rad`: 0 to pi.
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

/// The distance to a closed mesh: the lattice's spline. The spline is defined on a box, one node spacing inside the
/// lattice's border. Outside the box the distance is sqrt(gap^2 + d^2), with the distance gap to the nearest point of
/// the box and the spline's value d there. It is continuous and never more than the true distance, because the mesh
/// lies inside the box. Not 1-Lipschitz where the spline is not: its slope is at most sqrt(3).
[[nodiscard]] ShapeAt mesh_at(const Eigen::Vector3d& p, const DistanceLattice& lattice) noexcept;

}  // namespace telepalp::solids
