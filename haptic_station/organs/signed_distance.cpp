#include "haptic_station/organs/signed_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic_station/organs/closed_mesh.h"

namespace telepalp::organs {
namespace {

using Eigen::Vector3d;

constexpr int kBlock = 4;  // nodes along an edge of a block; all nodes of a block share one list of candidate faces
constexpr double kMostNodes = 16e6;

struct Ball {
  Vector3d center;
  double radius_m;
};

std::vector<Ball> balls_around(const std::vector<ClosedFace>& faces) {
  std::vector<Ball> balls;
  balls.reserve(faces.size());
  for (const ClosedFace& face : faces) {
    const Vector3d center = (face.corners[0] + face.corners[1] + face.corners[2]) / 3.0;
    double radius_m = 0.0;
    for (const Vector3d& corner : face.corners) radius_m = std::max(radius_m, (corner - center).norm());
    balls.push_back({center, radius_m});
  }
  return balls;
}

struct Candidate {
  double least_m;  ///< lower bound of the distance from the block's centre to the face
  std::uint32_t face;
};

/// The faces that can be nearest to a point of a ball, nearest first.
void candidates_for(const Ball& block, const std::vector<Ball>& balls, std::vector<Candidate>& candidates) {
  double farthest_m = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) farthest_m = std::min(farthest_m, (ball.center - block.center).norm() + ball.radius_m);
  candidates.clear();
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const double least_m = (balls[i].center - block.center).norm() - balls[i].radius_m;
    if (least_m <= farthest_m + 2.0 * block.radius_m) candidates.push_back({least_m, i});
  }
  std::ranges::sort(candidates, {}, &Candidate::least_m);
}

/// `from_center_m`: distance of the point from the block's centre.
double signed_distance_m(const Vector3d& point, double from_center_m, const std::vector<ClosedFace>& faces,
                         const std::vector<Candidate>& candidates) {
  NearestOnFace nearest{std::numeric_limits<double>::infinity(), Vector3d::Zero(), nullptr};
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : candidates) {
    if (candidate.least_m - from_center_m > nearest_m) break;
    const NearestOnFace on = nearest_on(faces[candidate.face], point);
    if (on.squared_m2 >= nearest.squared_m2) continue;
    nearest = on;
    nearest_m = std::sqrt(on.squared_m2);
  }
  const bool outside = (point - nearest.at_m).dot(*nearest.normal) >= 0.0;
  return outside ? nearest_m : -nearest_m;
}

/// An empty lattice around the faces.
Result<solids::DistanceLattice> lattice_around(const std::vector<ClosedFace>& faces, double spacing_m,
                                               double margin_m) {
  Eigen::AlignedBox3d box;
  for (const ClosedFace& face : faces)
    for (const Vector3d& corner : face.corners) box.extend(corner);
  solids::DistanceLattice lattice;
  lattice.origin_m = box.min() - Vector3d::Constant(margin_m);
  lattice.spacing_m = spacing_m;
  const Vector3d cells = ((box.sizes().array() + 2.0 * margin_m) / spacing_m).ceil();
  if (!(cells.prod() < kMostNodes))
    return Error{.what = "would need a grid of more than 16 million points",
                 .where = {},
                 .fix = "give larger cells (cell_m), or check the unit of the file's coordinates (unit_m)"};
  for (int axis = 0; axis < 3; ++axis) lattice.size[static_cast<std::size_t>(axis)] = static_cast<int>(cells[axis]) + 1;
  lattice.nodes_m.resize(lattice.index(0, 0, lattice.size[2]));
  return lattice;
}

void fill_block(const std::array<int, 3>& first, const std::vector<ClosedFace>& faces, const std::vector<Ball>& balls,
                std::vector<Candidate>& candidates, solids::DistanceLattice& lattice) {
  const auto node = [&](int i, int j, int k) {
    return Vector3d(lattice.origin_m + lattice.spacing_m * Vector3d(i, j, k));
  };
  constexpr double kHalf = 0.5 * (kBlock - 1);
  const Vector3d center = node(first[0], first[1], first[2]) + Vector3d::Constant(kHalf * lattice.spacing_m);
  candidates_for({center, std::sqrt(3.0) * kHalf * lattice.spacing_m}, balls, candidates);
  for (int k = first[2]; k < std::min(first[2] + kBlock, lattice.size[2]); ++k)
    for (int j = first[1]; j < std::min(first[1] + kBlock, lattice.size[1]); ++j)
      for (int i = first[0]; i < std::min(first[0] + kBlock, lattice.size[0]); ++i) {
        const Vector3d at = node(i, j, k);
        const double distance_m = signed_distance_m(at, (at - center).norm(), faces, candidates);
        lattice.nodes_m[lattice.index(i, j, k)] = static_cast<float>(distance_m);
      }
}

}  // namespace

Result<solids::DistanceLattice> signed_distance(const models::PointModel& mesh, double spacing_m, double margin_m) {
  const Result<std::vector<ClosedFace>> faces = closed_faces(mesh);
  if (!faces) return faces.error();
  Result<solids::DistanceLattice> lattice = lattice_around(*faces, spacing_m, margin_m);
  if (!lattice) return lattice;
  const std::vector<Ball> balls = balls_around(*faces);
  std::vector<Candidate> candidates;
  for (int k = 0; k < lattice->size[2]; k += kBlock)
    for (int j = 0; j < lattice->size[1]; j += kBlock)
      for (int i = 0; i < lattice->size[0]; i += kBlock) fill_block({i, j, k}, *faces, balls, candidates, *lattice);
  return lattice;
}

}  // namespace telepalp::organs
