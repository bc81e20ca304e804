#include "haptic_station/surface/cloud/static_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Vector3d middle_of(const std::vector<Vector3f>& points) {
  Vector3d sum = Vector3d::Zero();
  double count = 0.0;
  for (const Vector3f& at : points)
    if (at.allFinite()) {
      sum += at.cast<double>();
      count += 1.0;
    }
  return count > 0.0 ? Vector3d(sum / count) : Vector3d::Zero();
}

/// In metres around the model's middle, so that floats stay exact however far away its frame's origin is.
models::PointModel centred(const models::PointModel& model, const Vector3d& middle, double unit_m) {
  models::PointModel near = model;
  for (Vector3f& at : near.points) at = (unit_m * (at.cast<double>() - middle)).cast<float>();
  for (Vector3f& normal : near.normals) normal.normalize();
  return near;
}

/// How a mesh encloses what it encloses.
struct Closure {
  double volume6 = 0.0;           ///< six times the signed volume; positive where faces look outwards
  double agreement = 0.0;         ///< of the vertices' normals with their faces', by area; zero without normals
  std::size_t open_edges = 0;     ///< without a partner
  std::size_t without_place = 0;  ///< triangles with a corner that is not finite
};

Closure closure_of(const models::PointModel& model) {
  Closure closure;
  std::map<std::array<float, 6>, int> edges;  // by position: exporters double the vertices along seams
  const auto key = [&](std::uint32_t a, std::uint32_t b) {
    const Vector3f& p = model.points[a];
    const Vector3f& q = model.points[b];
    return std::array<float, 6>{p.x(), p.y(), p.z(), q.x(), q.y(), q.z()};
  };
  for (const auto& triangle : model.triangles) {
    const Vector3d a = model.points[triangle[0]].cast<double>();
    const Vector3d b = model.points[triangle[1]].cast<double>();
    const Vector3d c = model.points[triangle[2]].cast<double>();
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      ++closure.without_place;
      continue;
    }
    closure.volume6 += a.dot(b.cross(c));
    for (std::size_t k = 0; k < 3; ++k) {
      if (!model.normals.empty() && model.normals[triangle[k]].allFinite())
        closure.agreement += (b - a).cross(c - a).dot(model.normals[triangle[k]].cast<double>());
      ++edges[key(triangle[k], triangle[(k + 1) % 3])];
      --edges[key(triangle[(k + 1) % 3], triangle[k])];
    }
  }
  for (const auto& [edge, balance] : edges)
    if (balance > 0) ++closure.open_edges;
  return closure;
}

void say(std::string& remarks, const std::string& remark) { remarks += (remarks.empty() ? "" : "; ") + remark; }

std::vector<CloudPoint> sampled_mesh(const models::PointModel& mesh, const StaticModelSettings& settings,
                                     std::string& remarks) {
  std::vector<CloudPoint> points = poisson_disk_samples(mesh, settings.samples, settings.seed);
  if (mesh.normals.empty()) say(remarks, "the mesh has no normals: its faces' are taken");
  const Closure closure = closure_of(mesh);
  const bool against_faces = closure.agreement < 0.0;
  if (closure.without_place > 0)
    say(remarks, std::to_string(closure.without_place) + " triangles have a corner that is not a number: left out");
  if (closure.open_edges > 0) {
    say(remarks, "the mesh is open (" + std::to_string(closure.open_edges) +
                     " edges without a partner), so which side is outside is taken from its " +
                     (mesh.normals.empty() ? "faces" : "normals"));
  } else if ((closure.volume6 < 0.0) != against_faces) {
    say(remarks, "the mesh is inside out: its normals are turned over");
    for (CloudPoint& point : points) point.normal = -point.normal;
  }
  return points;
}

std::vector<CloudPoint> cloud_points(const models::PointModel& cloud, const StaticModelSettings& settings,
                                     const Vector3d& middle, std::string& remarks) {
  if (cloud.normals.empty()) {
    say(remarks, "the cloud has no normals: they are estimated from " + std::to_string(settings.normal_neighbors) +
                     " neighbours and turned to the viewpoint");
    return with_normals(cloud.points, settings.normal_neighbors, (settings.viewpoint_m - middle).cast<float>());
  }
  std::vector<CloudPoint> points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.points[i].allFinite() && cloud.normals[i].allFinite() && cloud.normals[i].norm() > 0.5F)
      points.push_back({cloud.points[i], cloud.normals[i]});
  return points;
}

}  // namespace

bool spans_a_surface(const models::PointModel& model) {
  const Vector3d middle = middle_of(model.points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3f& at : model.points)
    if (at.allFinite()) {
      const Vector3d from = at.cast<double>() - middle;
      spread += from * from.transpose();
    }
  const Vector3d sizes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  return sizes[1] > 1e-9 * sizes[2] && sizes[2] > 0.0;
}

Error no_surface() {
  return {.what = "has no surface: no finite points, or all in one place or on one line",
          .where = "model",
          .fix = "give a cloud of a surface, three points or more apart from each other"};
}

Result<StaticModel> make_static_model(const models::PointModel& model, const StaticModelSettings& settings) {
  const Vector3d middle = middle_of(model.points);
  const models::PointModel near = centred(model, middle, settings.unit_m);
  if (const std::string complaint = models::unit_complaint(near); !complaint.empty())
    return Error{.what = complaint, .where = "model", .fix = models::kSayTheUnit};
  StaticModel made;
  std::vector<CloudPoint> points = near.triangles.empty()
                                       ? cloud_points(near, settings, settings.unit_m * middle, made.remarks)
                                       : sampled_mesh(near, settings, made.remarks);
  if (points.empty()) return no_surface();
  if (settings.flip_normals)
    for (CloudPoint& point : points) point.normal = -point.normal;
  CloudShape shape;
  shape.origin_m = settings.unit_m * middle;
  shape.support_m = settings.support_m;
  made.snapshot = std::make_shared<const CloudSnapshot>(std::move(points), shape, Index::Nanoflann);
  return made;
}

}  // namespace telepalp::surface
