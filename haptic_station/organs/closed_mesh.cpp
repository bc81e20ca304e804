#include "haptic_station/organs/closed_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "proto/words/counted.h"

namespace telepalp::organs {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// For each vertex, the index of the first vertex at the same position.
std::vector<std::uint32_t> welded(const std::vector<Eigen::Vector3f>& points) {
  const auto key = [&](std::uint32_t i) { return std::array{points[i].x(), points[i].y(), points[i].z()}; };
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

std::vector<Triangle> welded_triangles(const models::PointModel& mesh) {
  const std::vector<std::uint32_t> first = welded(mesh.points);
  std::vector<Triangle> triangles;
  for (const Triangle& given : mesh.triangles) {
    const Triangle t{first[given[0]], first[given[1]], first[given[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
  }
  return triangles;
}

/// The number of edges that do not have equally many faces in both directions.
std::size_t open_edges(const std::vector<Triangle>& triangles) {
  std::map<Edge, int> balance;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % 3];
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  return static_cast<std::size_t>(std::ranges::count_if(balance, [](const auto& edge) { return edge.second != 0; }));
}

double volume_m3(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector3f>& points) {
  double sum = 0.0;
  for (const Triangle& t : triangles)
    sum += points[t[0]].cast<double>().dot(points[t[1]].cast<double>().cross(points[t[2]].cast<double>())) / 6.0;
  return sum;
}

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

std::vector<ClosedFace> faces_of(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector3f>& points) {
  std::vector<ClosedFace> faces(triangles.size());
  std::vector<Vector3d> at_vertex(points.size(), Vector3d::Zero());
  std::map<Edge, Vector3d> at_edge;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    ClosedFace& face = faces[f];
    for (std::size_t i = 0; i < 3; ++i) face.corners[i] = points[triangles[f][i]].cast<double>();
    const Vector3d across = (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]);
    face.normal = across.norm() > 0.0 ? Vector3d(across.normalized()) : Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const Vector3d& corner = face.corners[i];
      const double angle = angle_between(face.corners[next] - corner, face.corners[(i + 2) % 3] - corner);
      at_vertex[triangles[f][i]] += angle * face.normal;
      at_edge.try_emplace(std::minmax(triangles[f][i], triangles[f][next]), Vector3d::Zero()).first->second +=
          face.normal;
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      faces[f].corner_normals[i] = at_vertex[triangles[f][i]];
      faces[f].edge_normals[i] = at_edge.at(std::minmax(triangles[f][i], triangles[f][(i + 1) % 3]));
    }
  return faces;
}

}  // namespace

Result<std::vector<ClosedFace>> closed_faces(const models::PointModel& mesh) {
  std::vector<Triangle> triangles = welded_triangles(mesh);
  if (triangles.empty())
    return Error{.what = "has no faces with an area", .where = {}, .fix = "give a mesh with faces, as PLY or OBJ"};
  for (const Triangle& t : triangles)
    for (const std::uint32_t corner : t)
      if (!mesh.points[corner].allFinite())
        return Error{.what = "has a face with a corner whose position is not finite",
                     .where = {},
                     .fix = "export the mesh again"};
  if (const std::size_t open = open_edges(triangles); open > 0)
    return Error{
        .what = "is not closed: " + counted(open, "edge lacks a face, or joins", "edges lack a face, or join") +
                " two faces of opposite orientation",
        .where = {},
        .fix = "close its holes, and orient all faces outwards"};
  const double volume = volume_m3(triangles, mesh.points);
  if (!(std::abs(volume) > 1e-9))
    return Error{.what = "encloses less than 1 mm^3",
                 .where = {},
                 .fix = "check unit_m (metres per unit of the file's coordinates), or give a mesh that is not flat"};
  if (volume < 0.0)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return faces_of(triangles, mesh.points);
}

// Ericson, Real-Time Collision Detection (2005), 5.1.5: finds the corner, edge or face in whose region the point's
// projection lies.
NearestOnFace nearest_on(const ClosedFace& face, const Vector3d& point) noexcept {
  const auto& [a, b, c] = face.corners;
  const auto found = [&](const Vector3d& at, const Vector3d& normal) {
    return NearestOnFace{(point - at).squaredNorm(), at, &normal};
  };
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const double d1 = ab.dot(point - a);
  const double d2 = ac.dot(point - a);
  if (d1 <= 0.0 && d2 <= 0.0) return found(a, face.corner_normals[0]);
  const double d3 = ab.dot(point - b);
  const double d4 = ac.dot(point - b);
  if (d3 >= 0.0 && d4 <= d3) return found(b, face.corner_normals[1]);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return found(a + d1 / (d1 - d3) * ab, face.edge_normals[0]);
  const double d5 = ab.dot(point - c);
  const double d6 = ac.dot(point - c);
  if (d6 >= 0.0 && d5 <= d6) return found(c, face.corner_normals[2]);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return found(a + d2 / (d2 - d6) * ac, face.edge_normals[2]);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return found(b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), face.edge_normals[1]);
  const double total = va + vb + vc;
  return found(a + ab * (vb / total) + ac * (vc / total), face.normal);
}

}  // namespace telepalp::organs
