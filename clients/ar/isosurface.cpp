#include "clients/ar/isosurface.h"

#include "proto/words/demand.h"
#include "support/isosurface/isosurface.h"

namespace telepalp::ar {
namespace {

/// By central differences.
Eigen::Vector3f gradient(const Field& field, const Eigen::Vector3f& at, float step) {
  Eigen::Vector3f slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3f offset = step * Eigen::Vector3f::Unit(axis);
    slope[axis] = (field(at + offset) - field(at - offset)) / (2.0F * step);
  }
  return slope;
}

}  // namespace

Mesh isosurface(const Field& field, const Eigen::AlignedBox3f& box, float cell) {
  const auto at = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3f point = p.cast<float>();
    return isosurface::FieldAt{field(point), gradient(field, point, 0.5F * cell).cast<double>()};
  };
  const auto value = [&](const Eigen::Vector3d& p) { return double{field(p.cast<float>())}; };
  const Result<isosurface::Extraction> made = isosurface::extract(
      {.at = at, .steepest = kSteepest, .value = value}, {.box = box.cast<double>(), .cell_m = cell, .examine = false});
  demand(made.ok(), "the surface is closed within its box, and its function is no steeper than stated");
  Mesh mesh{.vertices = {}, .triangles = made->mesh.triangles};
  for (const Eigen::Vector3d& point : made->mesh.points)
    mesh.vertices.push_back(
        {point.cast<float>(), gradient(field, point.cast<float>(), 0.5F * cell).normalized(), Eigen::Vector3f::Ones()});
  return mesh;
}

}  // namespace telepalp::ar
