#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

Snapshot plane_with_hole(int half_side_px) {
  return from_depth([=](int u, int v) {
    const bool hole = std::abs(u - 80) <= half_side_px && std::abs(v - 60) <= half_side_px;
    return hole ? 0.0 : 0.8;
  });
}

AssertionResult holes() {
  const Drive small = drive_on(plane_with_hole(1), line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const Drive large = drive_on(plane_with_hole(25), line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const Drive across = drive_on(plane_with_hole(25), line({-0.07, 0, 0.803}, {0, 0, 0.803}, 1.0), 1.0);
  return all_of({{small.last.in_body && std::abs(small.last.proxy.m.z() - 0.8) < 1e-4, "a small hole is bridged"},
                 {!large.touched && large.finite, "a large one is no contact"},
                 below_N("sliding into it lets go without a step", across.worst_step_N, kMostForceStep_N)});
}

AssertionResult silhouette() {
  const Snapshot step = from_depth([](int u, int) { return u < 80 ? 0.77 : 0.8; });
  double worst = 0.0;
  for (int px = 2; px < 12; ++px)
    for (const int side : {-1, 1}) {
      const double z = side < 0 ? 0.77 : 0.8;
      const double x = (side < 0 ? -px : px) * z / 533.3;
      const Drive drove = drive_on(step, line({x, 0, z - 0.004}, {x, 0, z + 0.003}, 0.1), 0.15);
      if (drove.last.in_body) worst = std::max(worst, std::abs(drove.last.foot.m.z() - z));
    }
  return all_of({below_m("no surface between the layers", worst, 2e-4)});
}

AssertionResult thin_sheet() {
  std::vector<CloudPoint> both = sheet(0.8F, true);
  for (const CloudPoint& back : sheet(0.803F, false)) both.push_back(back);
  const Snapshot skin = from_points(std::move(both));
  const Drive front = drive_on(skin, line({0, 0, 0.79}, {0, 0, 0.815}, 0.2), 0.4);
  const Drive behind = drive_on(skin, line({0, 0, 0.815}, {0, 0, 0.79}, 0.2), 0.4);
  return all_of({{front.last.in_body && std::abs(front.last.proxy.m.z() - 0.8) < 2e-4, "held on the front"},
                 {behind.last.in_body && std::abs(behind.last.proxy.m.z() - 0.803) < 2e-4, "held on the back"}});
}

AssertionResult rim_of_support() {
  const Snapshot half = from_depth([](int u, int) { return u < 80 ? 0.8 : 0.0; });
  const Drive drove = drive_on(half, line({-0.03, 0, 0.803}, {0.03, 0, 0.803}, 1.0), 1.2);
  double worst = 0.0;
  double last = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double coverage = half->evaluate({-0.02 + 1e-5 * i, 0.0, 0.8}, Vector3d::Zero(), {}).coverage;
    if (i > 0) worst = std::max(worst, std::abs(coverage - last));
    last = coverage;
  }
  return all_of({{drove.finite && drove.touched && !drove.last.in_body, "contact ends beyond the rim"},
                 below_N("without a step", drove.worst_step_N, kMostForceStep_N),
                 {worst < 0.01, "coverage fades smoothly"}});
}

AssertionResult shadow_of_an_arm() {
  const Snapshot arm = from_depth([](int u, int) { return std::abs(u - 80) < 20 ? 0.77 : 0.8; });
  const Drive under = drive_on(arm, line({-0.08, 0, 0.785}, {0.08, 0, 0.785}, 0.4), 0.4);
  return all_of(
      {{under.finite, "finite"}, {under.worst_force_N == 0.0, "passing behind a silhouette is not going through it"}});
}

AssertionResult at_the_camera() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  const Drive drove = drive_on(flat, line({0, 0, 0.3}, {0, 0, -0.5}, 0.4), 0.4);
  return all_of({{drove.finite, "finite"}, {!drove.touched, "no contact"}, {drove.worst_force_N == 0.0, "no force"}});
}

AssertionResult a_sliver() {
  const Snapshot sliver = from_depth([](int u, int) { return u == 80 ? 0.8 : 0.0; });
  const Drive drove = drive_on(sliver, line({0, 0, 0.79}, {0.0003, 0, 0.81}, 0.2), 0.3);
  const Drive across = drive_on(sliver, line({-0.02, 0, 0.803}, {0.02, 0, 0.803}, 0.3), 0.3);
  return all_of(
      {{drove.finite && across.finite, "finite"}, {!drove.touched && !across.touched, "no surface is made up"}});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> image_rows() {
  using namespace surface;
  return {
      {"5 depth hole", "zero means not measured", "small bridged, large no contact, no step", holes},
      {"6 silhouette", "neighbours in the image, far apart in space", "no surface between the layers", silhouette},
      {"7 thin sheet", "both sides are near", "stays on the entry side", thin_sheet},
      {"10 rim of the support", "weights go to zero", "C1, no 0/0, contact ends without a step", rim_of_support},
      {"35 behind a silhouette", "hidden space is not body", "no contact sideways", shadow_of_an_arm},
      {"36 device at the camera, and behind", "projection is singular there", "no contact, no NaN", at_the_camera},
      {"37 surface one pixel wide", "a line has no normal", "no surface invented", a_sliver},
  };
}

}  // namespace telepalp::hard_cases
