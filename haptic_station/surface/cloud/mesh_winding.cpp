#include "haptic_station/surface/cloud/mesh_winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace telepalp::surface {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// For each vertex, the index of the first vertex at the same position.
std::vector<std::uint32_t> first_in_place(const std::vector<Eigen::Vector3f>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t i) { return std::tuple(points[i].x(), points[i].y(), points[i].z()); };
  std::erase_if(order, [&](std::uint32_t i) { return !points[i].allFinite(); });
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  std::vector<std::uint32_t> first(points.size());
  std::iota(first.begin(), first.end(), 0U);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (place(order[i]) == place(order[i - 1])) first[order[i]] = first[order[i - 1]];
  return first;
}

/// A face's edge, with its lower vertex first.
struct Side {
  std::uint32_t low = 0, high = 0;
  std::uint32_t face = 0;
  bool upwards = false;  ///< the face traverses the edge from the lower to the higher vertex
};

/// The sides of all faces with an area, sorted so that the sides of one edge are adjacent.
std::vector<Side> sides_of(const models::PointModel& mesh) {
  const std::vector<std::uint32_t> first = first_in_place(mesh.points);
  std::vector<Side> sides;
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle& corners = mesh.triangles[face];
    const std::uint32_t at[3] = {first[corners[0]], first[corners[1]], first[corners[2]]};
    const bool finite =
        std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return mesh.points[c].allFinite(); });
    if (!finite || at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(at[k], at[(k + 1) % 3]);
      sides.push_back({low, high, face, at[k] == low});
    }
  }
  const auto edge = [](const Side& side) { return std::pair(side.low, side.high); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return edge(a) < edge(b); });
  return sides;
}

struct Neighbour {
  std::uint32_t face = 0;
  bool agrees = false;
};

struct Adjacency {
  std::vector<std::vector<Neighbour>> of_face;
  std::vector<bool> at_open_edge;  // of each face
  std::size_t open_edges = 0;
};

Adjacency adjacency_of(const models::PointModel& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  Adjacency adjacency{.of_face = {}, .at_open_edge = std::vector<bool>(mesh.triangles.size(), false)};
  adjacency.of_face.resize(mesh.triangles.size());
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    const auto same = [&](const Side& side) { return side.low == sides[from].low && side.high == sides[from].high; };
    for (to = from; to < sides.size() && same(sides[to]);) ++to;
    const Side& a = sides[from];
    if (to - from == 1) {
      ++adjacency.open_edges;
      adjacency.at_open_edge[a.face] = true;
    } else if (to - from == 2) {  // where more than two faces meet at an edge, their pairs are unknown
      const Side& b = sides[from + 1];
      adjacency.of_face[a.face].push_back({b.face, a.upwards != b.upwards});
      adjacency.of_face[b.face].push_back({a.face, a.upwards != b.upwards});
    }
  }
  return adjacency;
}

/// The faces of one connected piece, and which of them must be reversed to agree with the first.
struct Piece {
  std::vector<std::uint32_t> faces;
  std::vector<bool> turn;
  bool open = false;
};

Piece piece_from(std::uint32_t face, const Adjacency& adjacency, std::vector<bool>& seen) {
  Piece piece{.faces = {face}, .turn = {false}, .open = false};
  seen[face] = true;
  for (std::size_t i = 0; i < piece.faces.size(); ++i) {
    const std::uint32_t here = piece.faces[i];
    piece.open = piece.open || adjacency.at_open_edge[here];
    for (const Neighbour& neighbour : adjacency.of_face[here]) {
      if (seen[neighbour.face]) continue;
      seen[neighbour.face] = true;
      piece.faces.push_back(neighbour.face);
      piece.turn.push_back(piece.turn[i] != !neighbour.agrees);
    }
  }
  return piece;
}

/// Six times the volume that a piece encloses; positive if its faces are oriented outwards.
double volume6(const models::PointModel& mesh, const Piece& piece) {
  double sum = 0.0;
  for (const std::uint32_t face : piece.faces) {
    const Triangle& at = mesh.triangles[face];
    const Eigen::Vector3d a = mesh.points[at[0]].cast<double>();
    sum += a.dot(mesh.points[at[1]].cast<double>().cross(mesh.points[at[2]].cast<double>()));
  }
  return sum;
}

/// Orients a piece and returns the number of reversed faces.
std::size_t mend(models::PointModel& mesh, Piece& piece) {
  const auto against = static_cast<std::size_t>(std::count(piece.turn.begin(), piece.turn.end(), true));
  if (against == 0) return 0;
  const std::size_t fewer = std::min(against, piece.faces.size() - against);
  if (fewer < against) piece.turn.flip();
  for (std::size_t i = 0; i < piece.faces.size(); ++i)
    if (piece.turn[i]) std::swap(mesh.triangles[piece.faces[i]][1], mesh.triangles[piece.faces[i]][2]);
  if (piece.open || volume6(mesh, piece) >= 0.0) return fewer;
  for (const std::uint32_t face : piece.faces) std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
  return fewer;
}

}  // namespace

Winding make_faces_agree(models::PointModel& mesh) {
  const Adjacency adjacency = adjacency_of(mesh);
  Winding winding{.open_edges = adjacency.open_edges, .turned = 0};
  std::vector<bool> seen(mesh.triangles.size(), false);
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    if (seen[face] || adjacency.of_face[face].empty()) continue;
    Piece piece = piece_from(face, adjacency, seen);
    winding.turned += mend(mesh, piece);
  }
  return winding;
}

}  // namespace telepalp::surface
