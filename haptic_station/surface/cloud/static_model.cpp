#include "haptic_station/surface/cloud/static_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "haptic_station/surface/cloud/mesh_winding.h"
#include "haptic_station/surface/cloud/model_sampling.h"
#include "haptic_station/surface/cloud/touched_cloud.h"
#include "proto/words/counted.h"

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

/// Coordinates are in metres from the model's middle, so that floats are accurate even far from the origin of the
/// file's frame.
models::PointModel centred(const models::PointModel& model, const Vector3d& middle, double unit_m) {
  models::PointModel near = model;
  for (Vector3f& at : near.points) at = (unit_m * (at.cast<double>() - middle)).cast<float>();
  for (Vector3f& normal : near.normals) normal.normalize();
  return near;
}

/// The evidence of a mesh's faces and normals about its outside.
struct Closure {
  double volume6 = 0.0;           ///< six times the signed volume; positive if the faces are oriented outwards
  double agreement = 0.0;         ///< area-weighted mean cosine between vertex normals and face normals
  std::size_t without_place = 0;  ///< triangles with a corner that is not finite
};

Closure closure_of(const models::PointModel& model) {
  Closure closure;
  double area2 = 0.0;
  for (const auto& triangle : model.triangles) {
    const Vector3d a = model.points[triangle[0]].cast<double>();
    const Vector3d b = model.points[triangle[1]].cast<double>();
    const Vector3d c = model.points[triangle[2]].cast<double>();
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      ++closure.without_place;
      continue;
    }
    closure.volume6 += a.dot(b.cross(c));
    const Vector3d face = (b - a).cross(c - a);
    area2 += 3.0 * face.norm();
    for (std::size_t k = 0; k < 3; ++k)
      if (!model.normals.empty() && model.normals[triangle[k]].allFinite())
        closure.agreement += face.dot(model.normals[triangle[k]].cast<double>());
  }
  if (area2 > 0.0) closure.agreement /= area2;
  return closure;
}

/// Drops normals that contradict the faces and adds the defects of `mesh` to `remarks`. Returns -1 if all normals must
/// be reversed, else 1.
float mended(models::PointModel& mesh, const Winding& winding, std::string& remarks) {
  if (winding.turned > 0)
    add_remark(remarks,
               std::to_string(winding.turned) + " of " + std::to_string(mesh.triangles.size()) +
                   (winding.turned == 1 ? " faces was oriented against its neighbours: telepalp has reversed it"
                                        : " faces were oriented against their neighbours: telepalp has reversed them"));
  if (mesh.normals.empty()) add_remark(remarks, "the mesh has no normals: telepalp uses the normals of its faces");
  Closure closure = closure_of(mesh);
  constexpr double kLeastAgreement = 0.4;  // smooth shading over the edges of a cube gives 0.58
  if (!mesh.normals.empty() && std::abs(closure.agreement) < kLeastAgreement) {
    add_remark(remarks, "the mesh's normals contradict its faces: telepalp uses the normals of the faces");
    mesh.normals.clear();
    closure.agreement = 0.0;
  }
  if (closure.without_place > 0)
    add_remark(remarks, counted(closure.without_place, "triangle with a corner that is not a finite number is left out",
                                "triangles with a corner that is not a finite number are left out"));
  if (winding.open_edges > 0) {
    add_remark(remarks, "the mesh is open (" + counted(winding.open_edges, "edge", "edges") +
                            " with a face on one side only), so telepalp takes the side to which its " +
                            (mesh.normals.empty() ? "faces" : "normals") + " point as its outside");
    return 1.0F;
  }
  if ((closure.volume6 < 0.0) == (closure.agreement < 0.0)) return 1.0F;
  add_remark(remarks, "the mesh is inside out: telepalp has reversed its normals");
  return -1.0F;
}

Error too_coarse(const SampledMesh& sampled) {
  char fix[200];
  const double by_error = std::sqrt(kFaithful_m / std::max(kFaithful_m, sampled.fidelity.error_m));
  const double faithful_m = sampled.spacing_m * std::min(by_error, sampled.fidelity.in_air > 0.0 ? 0.5 : 1.0);
  std::snprintf(fix, sizeof fix,
                "give more samples, so that they are %.1f mm apart; or leave samples and spacing out, so that telepalp "
                "chooses them; or accept the coarse samples by --anyway",
                1e3 * faithful_m);
  return {.what = "is sampled too coarsely: " + description_of(sampled), .where = "model", .fix = fix};
}

Result<StaticModel> touched_mesh(models::PointModel mesh, const StaticModelSettings& settings,
                                 const Vector3d& origin_m) {
  StaticModel made;
  const Winding winding = make_faces_agree(mesh);
  if (settings.flip_normals && winding.open_edges == 0) {
    if (!settings.anyway) return inside_out("mesh");
    add_remark(made.remarks, touched_from_inside("mesh"));
  }
  const float side = mended(mesh, winding, made.remarks) * (settings.flip_normals ? -1.0F : 1.0F);
  const SampledMesh sampled = sample_mesh(mesh, settings, origin_m, side);
  if (!sampled.snapshot) return no_surface();
  if (is_too_coarse(sampled.fidelity) && !settings.anyway) return too_coarse(sampled);
  made.sampling = description_of(sampled);
  made.snapshot = sampled.snapshot;
  made.thin_share = sampled.thin.share;
  return made;
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
  return {.what =
              "has no surface: no point has finite coordinates and, if the file gives normals, a usable normal; or all "
              "points lie on one line",
          .where = "model",
          .fix = "give a mesh whose faces have an area, or a cloud of three points or more that are not on one line"};
}

Error inside_out(const std::string& what) {
  return {.what = "is a closed " + what +
                  ", whose outside is known: with its normals flipped, the hand would be inside the body in free air",
          .where = "model",
          .fix = "leave out --flip-normals (flip_normals in a scene); or touch the " + what +
                 " from inside, as a hollow, by --anyway"};
}

void add_remark(std::string& remarks, const std::string& remark) { remarks += (remarks.empty() ? "" : "; ") + remark; }

std::string touched_from_inside(const std::string& what) {
  return "the " + what + " is closed and its normals are flipped: it is touched from inside, as a hollow";
}

Result<StaticModel> make_static_model(const models::PointModel& model, const StaticModelSettings& settings) {
  const Vector3d middle = middle_of(model.points);
  models::PointModel near = centred(model, middle, settings.unit_m);
  if (std::optional<Error> unit = models::unit_error(near, settings.unit_m)) return std::move(*unit);
  if (!near.triangles.empty()) return touched_mesh(std::move(near), settings, settings.unit_m * middle);
  return touched_cloud(near, settings, settings.unit_m * middle);
}

}  // namespace telepalp::surface
