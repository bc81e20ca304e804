#include <random>

#include "haptic_station/surface/paper/paper_surface.h"
#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

AssertionResult nothing_there() {
  const Snapshot none = from_depth([](int, int) { return 0.0; });
  const Drive drove = drive_on(none, line({0, 0, 0.7}, {0, 0, 0.9}, 0.1), 0.1);
  return all_of({{drove.finite, "finite"}, {!drove.last.valid, "not valid"}, {drove.worst_force_N == 0.0, "no force"}});
}

AssertionResult points_in_one_place() {
  const Snapshot heap = from_points(std::vector<CloudPoint>(100, {{0.0F, 0.0F, 0.8F}, {0.0F, 0.0F, -1.0F}}));
  const Drive drove = drive_on(heap, line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const std::vector<Vector3f> bare(100, Vector3f(0.0F, 0.0F, 0.8F));
  return all_of({{drove.finite, "finite"},
                 below_N("force bounded", drove.worst_force_N, 0.01 * kStiffness_N_per_m),
                 {with_normals(bare, 10, Vector3f::Zero()).empty(), "no normal is made up"}});
}

AssertionResult points_on_a_line() {
  IndexedPoints points;
  for (int i = -50; i <= 50; ++i) points.at_m.emplace_back(0.001F * static_cast<float>(i), 0.0F, 0.8F);
  const PaperSurface paper(points, *surface_settings("paper-nanoflann"));
  const FieldSample sample = paper.evaluate({0.0, 0.0, 0.79}, Vector3d::Zero(), {});
  return all_of({{sample.valid, "valid"},
                 {sample.normal.z() < -0.99, "the view ray stands in for the normal"},
                 {with_normals(points.at_m, 10, Vector3f::Zero()).empty(), "the default leaves the points out"}});
}

AssertionResult points_on_a_plane() {
  const Snapshot flat = from_points(sheet(0.8F, true));
  double worst = 0.0;
  for (int i = -40; i <= 40; ++i) {
    const Vector3d at(0.0002 * i, 0.0001 * i, 0.8 + 0.00005 * i);
    worst = std::max(worst, std::abs(flat->evaluate(at, Vector3d::Zero(), {}).f_m + 0.00005 * i));
  }
  const auto tilted = testing::plane({0, 0, 0.8}, {0.3, -0.2, -1.0});
  const Snapshot grid = from_shape(*tilted);
  double worst_grid = 0.0;
  for (int i = -40; i <= 40; ++i) {
    const Vector3d at(0.0003 * i, -0.0002 * i, 0.8 + 0.0001 * i);
    worst_grid =
        std::max(worst_grid, std::abs(grid->evaluate(at, Vector3d::Zero(), {}).f_m - tilted->foot(at).distance_m));
  }
  return all_of({below_m("f is linear on points", worst, 1e-7),
                 below_m("f is linear on a depth image, to its rounding", worst_grid, 5e-6)});
}

AssertionResult neighbours_change() {
  std::mt19937_64 random(3);
  std::normal_distribution<float> noise(0.0F, 0.001F);
  std::vector<CloudPoint> points = sheet(0.8F, true);
  for (CloudPoint& point : points) point.at_m.z() += noise(random);
  const Snapshot rough = from_points(std::move(points));
  const Snapshot grid = from_depth([&](int, int) { return 0.8 + static_cast<double>(noise(random)); });
  double worst = 0.0;
  for (const Snapshot& snapshot : {rough, grid}) {
    double last = snapshot->evaluate({-0.01, 0.0031, 0.8}, {0, 0, -1}, {}).f_m;
    for (int i = 1; i < 20000; ++i) {
      const double f = snapshot->evaluate({-0.01 + 1e-6 * i, 0.0031, 0.8}, {0, 0, -1}, {}).f_m;
      worst = std::max(worst, std::abs(f - last));
      last = f;
    }
  }
  return all_of({below_m("f changes by at most 2 um over 1 um", worst, 2e-6)});
}

AssertionResult flipped_normal() {
  std::vector<CloudPoint> points = sheet(0.8F, true);
  for (std::size_t i = 0; i < points.size(); i += 29) points[i].normal = -points[i].normal;
  const Drive drove = drive_on(from_points(std::move(points)), line({0, 0, 0.79}, {0.004, 0, 0.805}, 0.2), 0.4);
  return all_of({{drove.last.in_body, "in contact"},
                 below_m("on the surface", std::abs(drove.last.proxy.m.z() - 0.8), 2e-4),
                 {drove.last.normal.z() < -0.999, "the many outvote the few"}});
}

AssertionResult far_from_the_origin() {
  CloudShape shape;
  shape.support_m = 0.006;
  shape.origin_m = Vector3d(12345.0, -54321.0, 9999.2);
  const Snapshot far = std::make_shared<const CloudSnapshot>(sheet(0.8F, true), shape, Index::Nanoflann);
  double worst = 0.0;
  for (int i = -20; i <= 20; ++i)
    worst = std::max(
        worst,
        std::abs(far->evaluate(shape.origin_m + Vector3d(1e-4 * i, 0, 0.8 + 1e-5 * i), Vector3d::Zero(), {}).f_m +
                 1e-5 * i));
  return all_of({below_m("f exact to 0.1 um", worst, 1e-7)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> point_rows() {
  using namespace surface;
  return {
      {"1 empty neighbourhood", "the sum of weights is zero", "outside, zero force, no NaN", nothing_there},
      {"2 coincident points", "they span no plane", "no normal invented; force bounded", points_in_one_place},
      {"3 collinear points", "the plane's rotation is undetermined", "normal is the view ray, or point left out",
       points_on_a_line},
      {"4 coplanar points", "the exact answer is known", "exact plane, f linear", points_on_a_plane},
      {"11 neighbours change", "the paper's f jumps by 269 um", "no force step", neighbours_change},
      {"12 flipped normals", "opposite normals cancel in the mean", "oriented by camera and last normal",
       flipped_normal},
      {"32 far from the origin", "floats lose digits", "local frame, exact", far_from_the_origin},
  };
}

}  // namespace telepalp::hard_cases
