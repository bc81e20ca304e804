// Meshes and clouds as people have them: parts inside parts, noise, normals that do not agree.

#include <filesystem>

#include "haptic_station/surface/cloud/static_model.h"
#include "tests/hard_cases/surface/driven.h"
#include "where.h"

namespace telepalp::surface {
namespace {

const std::filesystem::path kData = TELEPALP_SOURCE_DIR "/tests/data";

/// A place on a model's skin and its outward normal.
struct Place {
  Vector3d at;
  Vector3d out;
};

/// The worst force step of a hand that presses 2 mm deep and slides 5 mm to the side.
double worst_step_N(const SurfaceSnapshot& model, const Place& place) {
  const Vector3d out = place.out.normalized();
  const Vector3d side = 0.005 * out.unitOrthogonal();
  Touch touch;
  touch.adopt(model, at_s(1.0));
  const auto path = [&](double t) -> Vector3d {
    const Vector3d pressed = place.at + (0.003 - 0.005 * std::min(1.0, t / 0.06)) * out;
    return pressed + std::clamp((t - 0.06) / 0.05, 0.0, 1.0) * side;
  };
  return drive(touch, path, 0.12).worst_step_N;
}

AssertionResult fold_of_an_open_mesh() {
  const Place folds[] = {
      {{-0.0883, 0.3670, 0.0847}, {-0.49, -0.21, 0.85}}, {{-0.0647, 0.3713, 0.0041}, {0.73, -0.06, 0.68}},
      {{-0.0188, 0.3802, 0.0516}, {0.54, -0.81, -0.23}}, {{-0.0037, 0.3731, 0.0368}, {-0.38, -0.66, -0.65}},
      {{0.0087, 0.3752, 0.0325}, {0.21, -0.84, -0.49}},  {{-0.0317, 0.3452, -0.0023}, {0.21, -0.85, 0.48}}};
  const auto liver = models::read_point_model(kData / "mesh/VH_M_Liver.ply");
  if (!liver) return AssertionFailure() << to_string(liver.error());
  const auto model = make_static_model(*liver, {});
  if (!model) return AssertionFailure() << to_string(model.error());
  double worst_N = 0.0;
  for (const Place& fold : folds) worst_N = std::max(worst_N, worst_step_N(*model->snapshot, fold));
  const auto says = [&](const char* words) { return model->sampling.find(words) != std::string::npos; };
  return all_of({below_N("no force step", worst_N, 0.2),
                 {says("24 % of the mesh lies inside other parts"), "walls inside the liver are left out"},
                 {says("contact is felt in free air"), "free air of an open mesh is looked at"},
                 {says("jumps from one wall to another"), "folds that still jump are said"}});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> model_rows() {
  using namespace surface;
  return {
      {"38 fold of an open mesh", "1.9 N: walls lie inside other parts", "inner walls left out; folds that jump said",
       fold_of_an_open_mesh},
  };
}

}  // namespace telepalp::hard_cases
