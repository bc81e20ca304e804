#include <numbers>

#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

constexpr double kRadius_m = 0.08;

struct SlopeError {
  double position_m = 0.0;  ///< RMS distance of the foot from the sphere
  double normal_deg = 0.0;  ///< RMS
  bool all_touched = true;
};

Vector3d centre() { return {0.0, 0.0, 0.8 + kRadius_m}; }

/// The place on the sphere whose normal is `slope_deg` off the ray to it, `turn` about the camera's axis.
Vector3d place(double slope_deg, double turn) {
  double low = 0.0;
  double high = 0.5 * std::numbers::pi;  // angle at the sphere's centre
  const auto at = [&](double angle) -> Vector3d {
    const Vector3d n(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), -std::cos(angle));
    return centre() + kRadius_m * n;
  };
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (low + high);
    const Vector3d normal = (at(middle) - centre()) / kRadius_m;
    const bool steeper = -normal.dot(at(middle).normalized()) < std::cos(slope_deg * std::numbers::pi / 180.0);
    (steeper ? high : low) = middle;
  }
  return at(low);
}

/// Presses 5 mm deep along the normal, at places all around the sphere.
SlopeError pressed_at(const Snapshot& snapshot, double slope_deg) {
  constexpr int kPlaces = 24;
  SlopeError error;
  double square_m2 = 0.0;
  double square_sine = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const Vector3d at = place(slope_deg, 0.13 + 2.0 * std::numbers::pi * i / kPlaces);
    const Vector3d normal = (at - centre()) / kRadius_m;
    const Vector3d end = at - 0.005 * normal;
    const Drive drove = drive_on(snapshot, line(at + 0.01 * normal, end, 0.1), 0.15);
    error.all_touched = error.all_touched && drove.last.in_body;
    if (!drove.last.in_body) continue;
    const Vector3d from = drove.last.foot.m - centre();
    square_m2 += std::pow(from.norm() - kRadius_m, 2) / kPlaces;
    square_sine += from.normalized().cross(drove.last.normal).squaredNorm() / kPlaces;
  }
  error.position_m = std::sqrt(square_m2);
  error.normal_deg = std::sqrt(square_sine) * 180.0 / std::numbers::pi;
  return error;
}

AssertionResult skin_that_turns_away() {
  const Snapshot snapshot = from_shape(*testing::sphere(centre(), kRadius_m));
  const SlopeError at_40 = pressed_at(snapshot, 40.0);
  const SlopeError at_55 = pressed_at(snapshot, 55.0);
  const SlopeError at_65 = pressed_at(snapshot, 65.0);
  const SlopeError at_72 = pressed_at(snapshot, 72.0);
  const SlopeError at_78 = pressed_at(snapshot, 78.0);
  return all_of({below_m("at 40 degrees", at_40.position_m, 10e-6),
                 below_m("at 55", at_55.position_m, 10e-6),
                 below_m("at 65", at_65.position_m, 20e-6),
                 below_m("at 72", at_72.position_m, 30e-6),
                 below_m("at 78", at_78.position_m, 200e-6),
                 below("normal at 72", at_72.normal_deg, 0.5, 1.0, "deg"),
                 {at_78.all_touched, "all touched"}});
}

/// A plane is exact at any slant, with the fit in the image as with the fit on the skin.
AssertionResult steep_plane() {
  double worst_m = 0.0;
  for (const double slope_deg : {30.0, 52.0, 70.0}) {
    const double angle = slope_deg * std::numbers::pi / 180.0;
    const auto plane = testing::plane({0.0, 0.0, 0.8}, {std::sin(angle), 0.0, -std::cos(angle)});
    const Snapshot snapshot = from_shape(*plane);
    for (int i = -4; i <= 4; ++i) {
      const Vector3d at(0.005 * i * std::cos(angle), 0.004 * i, 0.8 + 0.005 * i * std::sin(angle));
      worst_m = std::max(worst_m, std::abs(snapshot->evaluate(at, Vector3d::Zero(), {}).f_m));
    }
  }
  return all_of({below_m("off the plane", worst_m, 5e-6)});
}

/// The default setting, after one second of images with a noise of 1 mm.
AssertionResult noise_on_a_slope() {
  const auto ball = testing::sphere(centre(), kRadius_m);
  const Intrinsics camera = small_camera();
  const DepthImage clean = testing::render(*ball, camera, {});
  SurfaceBuilder builder{SurfaceSettings{}};
  Snapshot snapshot;
  for (std::uint64_t n = 0; n < 30; ++n)
    snapshot = builder.add(testing::with_noise(clean, {.sigma_m = 0.001, .seed = n + 1}), camera,
                           at_s(static_cast<double>(n) / 30.0), std::nullopt);
  const SlopeError at_45 = pressed_at(snapshot, 45.0);
  const auto against = [&](const char* what, double slope_deg) {
    const double share = pressed_at(snapshot, slope_deg).position_m / at_45.position_m;
    return below(what, share, 1.1, 1.0, "x");
  };
  return all_of({below_m("at 45 degrees", at_45.position_m, 50e-6), against("at 55, of it", 55.0),
                 against("at 65", 65.0), against("at 72", 72.0)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> slope_rows() {
  using namespace surface;
  return {
      {"42 skin that turns away", "its depth in the image ends vertically", "to 30 um up to 72 degrees, touched at 78",
       skin_that_turns_away},
      {"43 steep plane", "two fits are blended", "exact with both", steep_plane},
      {"44 noise on a slope", "pixels are far apart there", "no more error than at 45 degrees", noise_on_a_slope},
  };
}

}  // namespace telepalp::hard_cases
