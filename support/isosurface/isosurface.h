#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::isosurface {

/// Value of an implicit function at a point: negative inside. `gradient`: of `m`; shorter than 1 where two
/// parts of the surface are equally near.
struct FieldAt {
  double m = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// A part of the solid that is as small as `size_m`: within `box` no cell is larger.
struct Feature {
  Eigen::AlignedBox3d box;
  double size_m = 0.0;
};

/// An implicit function whose value changes by at most `steepest` per metre.
struct Field {
  std::function<FieldAt(const Eigen::Vector3d&)> at;
  double steepest = 1.0;
  std::vector<Feature> features{};
  std::function<double(const Eigen::Vector3d&)> value{};  ///< at().m alone, if that costs less

  [[nodiscard]] double m_at(const Eigen::Vector3d& point) const { return value ? value(point) : at(point).m; }
};

/// Where and how finely the surface is looked for.
struct Grid {
  Eigen::AlignedBox3d box;  ///< contains the surface
  double cell_m = 0.0;      ///< side of the largest cells
  int halvings = 0;         ///< how often a cell may be halved where the surface needs it, 0 to kMostHalvings
  std::size_t most_cells = 2'000'000;     ///< bounds memory, about 200 bytes a cell, and time
  bool examine = true;                    ///< false: cells of one size, and no doubt is reported; fast, for pictures
  Eigen::Vector3d offset{.37, .61, .43};  ///< of the cells' corners, in largest cells; keeps flat faces off the corners
  std::function<void(double)> progress{};  ///< called now and then with the share of the box that is done, 0 to 1
  std::stop_token stop{};  ///< asked at each cell and each point of the surface; extract() then ends with an error
};
inline constexpr int kMostHalvings = 14;

/// A surface of triangles, counter-clockwise from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Two parallel sheets of the surface that share a cell of the smallest size: the mesh may join or lose them.
struct Tight {
  Eigen::Vector3d at;
  double apart_m;  ///< distance between the sheets
};

struct Extraction {
  Mesh mesh;
  std::optional<Tight> tightest;  ///< nullopt: all parallel sheets lie in cells of their own
  std::size_t unsure = 0;         ///< cells of the smallest size in which the shape of the surface remains in doubt
  std::size_t cells = 0;
  double finest_m = 0.0;  ///< side of the smallest cell used
};

/// The surface field = 0, by dual contouring (Ju, Losasso, Schaefer and Warren 2002) on an octree: one vertex for each
/// piece of surface in a cell, at the least-squares meeting point of the surface's tangent planes, so that edges and
/// corners stay sharp. A cell is halved while its corners, edges, faces and middle disagree about the surface's course
/// (Ju's test), while two sheets of the surface pass through it, while the surface bends in it by more than 5 % of its
/// side, and while it is larger than a feature in it. Each edge belongs to exactly two triangles, because a cell in
/// which several pieces meet has a vertex for each (Schaefer, Ju and Warren 2007).
/// Error: more than `most_cells` cells, a corner beyond 2^20 smallest half cells, or `stop` was requested.
[[nodiscard]] Result<Extraction> extract(const Field& field, const Grid& grid);

}  // namespace telepalp::isosurface
