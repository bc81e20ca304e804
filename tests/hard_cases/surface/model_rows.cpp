// Meshes and clouds as people have them: parts inside parts, noise, normals that do not agree.

#include <filesystem>
#include <random>

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
                 {says("19 % of the mesh lies inside other parts of it and is left out"), "walls inside the liver are left out"},
                 {says("contact is felt in free air"), "free air of an open mesh is looked at"},
                 {says("jumps from one wall of a fold to the other"), "folds that still jump are said"}});
}

/// A real carton, taken from all points of a depth camera's view, with noise along each axis.
models::PointModel carton(float noise_m) {
  models::PointModel cloud = *models::read_point_model(kData / "pcd/milk_color.pcd");
  std::mt19937 random(5);
  std::normal_distribution<float> noise(0.0F, noise_m);
  for (Vector3f& at : cloud.points) at += Vector3f(noise(random), noise(random), noise(random));
  return cloud;
}

/// A ball of 0.1 m at 0.8 m with its outward normals.
models::PointModel ball_cloud() {
  models::PointModel cloud;
  constexpr int kPoints = 12'000;
  for (int i = 0; i < kPoints; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / kPoints;
    const double turn = i * 2.399963;
    const Vector3d n(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z);
    cloud.points.push_back((Vector3d(0, 0, 0.8) + 0.1 * n).cast<float>());
    cloud.normals.push_back(n.cast<float>());
  }
  return cloud;
}

void reverse_at_random(models::PointModel& cloud) {
  std::mt19937 random(2);
  for (Vector3f& normal : cloud.normals)
    if (random() % 2 == 0) normal = -normal;
}

/// The worst force step of presses at places that the clean cloud shows.
double worst_step_on_carton_N(const SurfaceSnapshot& model) {
  const std::vector<CloudPoint> clean = with_normals(carton(0.0F).points, 30, Vector3f::Zero());
  double worst_N = 0.0;
  for (std::size_t i = 0; i < clean.size(); i += 137)
    worst_N = std::max(worst_N, worst_step_N(model, {clean[i].at_m.cast<double>(), clean[i].normal.cast<double>()}));
  return worst_N;
}

AssertionResult noisy_cloud() {
  const models::PointModel noisy = carton(0.002F);
  const auto model = make_static_model(noisy, {});
  if (!model) return AssertionFailure() << to_string(model.error());
  const Snapshot without_noise_in_mind = from_points(with_normals(noisy.points, 16, Vector3f::Zero()), 0.0);
  const double before_N = worst_step_on_carton_N(*without_noise_in_mind);
  const auto refused = make_static_model(carton(0.01F), {});
  return all_of(
      {above("three spacings step", before_N, 0.5, 1.0, "N"),
       below_N("the support that follows does not", worst_step_on_carton_N(*model->snapshot), 0.2),
       {model->sampling.find("because of this noise, each place is averaged over") != std::string::npos, "said"},
       {!refused.ok() && refused.error().what.find("too noisy") != std::string::npos, "10 mm is refused"}});
}

AssertionResult inverted_normals() {
  models::PointModel cloud = ball_cloud();
  for (Vector3f& normal : cloud.normals) normal = -normal;
  const auto model = make_static_model(cloud, {});
  if (!model) return AssertionFailure() << to_string(model.error());
  const Drive drove = drive_on(model->snapshot, line({0, 0, 0.68}, {0, 0, 0.71}, 0.2), 0.3);
  const bool said = model->remarks.find("100.0 % of its normals pointed inwards") != std::string::npos;
  return all_of({{drove.last.in_body && drove.last.normal.z() < -0.99, "touched from outside"},
                 below_m("on the ball", std::abs(drove.last.proxy.m.z() - 0.7), 2e-4),
                 {said, "100 % said"}});
}

AssertionResult random_normals() {
  models::PointModel closed = ball_cloud();
  reverse_at_random(closed);
  const auto model = make_static_model(closed, {});
  if (!model) return AssertionFailure() << to_string(model.error());
  const Drive drove = drive_on(model->snapshot, line({0, 0, 0.68}, {0, 0, 0.71}, 0.2), 0.3);
  models::PointModel open = carton(0.0F);
  const std::vector<CloudPoint> known = with_normals(open.points, 30, Vector3f::Zero());
  open.points.clear();
  for (const CloudPoint& point : known) {
    open.points.push_back(point.at_m);
    open.normals.push_back(point.normal);
  }
  const auto kept = make_static_model(open, {});
  reverse_at_random(open);
  const auto refused = make_static_model(open, {});
  const auto accepted = make_static_model(open, {.anyway = true});
  return all_of({{drove.last.in_body && drove.last.normal.z() < -0.99, "a closed cloud is mended"},
                 below_N("no force step", drove.worst_step_N, 0.2),
                 {kept.ok() && kept->remarks.empty(), "right ones are kept"},
                 {!refused.ok() && refused.error().what.find("contradict their") != std::string::npos, "open: refused"},
                 {accepted.ok(), "accepted anyway"}});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> model_rows() {
  using namespace surface;
  return {
      {"38 fold of an open mesh", "1.9 N: walls lie inside other parts", "inner walls left out; folds that jump said",
       fold_of_an_open_mesh},
      {"39 noisy cloud", "planes of noise; the proxy jumps", "the support follows the noise, or a refusal",
       noisy_cloud},
      {"40 inverted normals", "touched from inside", "a closed cloud is turned outwards, and said", inverted_normals},
      {"41 random normals", "means of opposites", "closed: mended; open: refused", random_normals},
  };
}

}  // namespace telepalp::hard_cases
