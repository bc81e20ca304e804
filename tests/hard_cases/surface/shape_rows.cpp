#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

AssertionResult concave_crease() {
  const auto valley = testing::crease(0.8, 0.8);  // |x| rises towards the camera on both sides
  const Snapshot snapshot = from_shape(*valley);
  Touch touch;
  touch.adopt(*snapshot, at_s(1.0));
  const auto path = [](double t) {
    return Vector3d(0.004 * std::sin(20.0 * t), 0.0, 0.79 + 0.025 * std::min(1.0, t / 0.3));
  };
  const Drive slid = drive(touch, path, 0.6);
  const Drive held = drive(
      touch, [&](double) { return path(0.6); }, 0.1, [](double) { return nullptr; }, 0.6);
  const Drive still = drive(
      touch, [&](double) { return path(0.6); }, 0.2, [](double) { return nullptr; }, 0.7);
  return all_of({{slid.finite && slid.last.in_body, "in contact"},
                 {held.last.in_body, "held"},
                 below_N("no chatter at rest", still.worst_step_N, 1e-3),
                 below_N("no jump from wall to wall", slid.worst_step_N, 0.3)});
}

AssertionResult vanishing_gradient() {
  std::vector<CloudPoint> ball;  // 4 mm radius, all of it within the support of its centre
  for (int i = 0; i < 400; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / 400.0;
    const double turn = i * 2.399963;
    const Vector3d n(std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z);
    ball.push_back({(Vector3d(0, 0, 0.8) + 0.004 * n).cast<float>(), n.cast<float>()});
  }
  const Drive drove = drive_on(from_points(std::move(ball), 0.008), line({0, 0, 0.79}, {0, 0, 0.8}, 0.2), 0.4);
  return all_of({{drove.finite, "finite"},
                 {std::abs(drove.last.normal.norm() - 1.0) < 1e-6, "the last plane holds"},
                 below_N("force bounded", drove.worst_force_N, 0.012 * kStiffness_N_per_m)});
}

AssertionResult fast_entry() {
  const auto bump = testing::gaussian_bump(0.8, 0.02, 0.04);
  const Snapshot snapshot = from_shape(*bump);
  for (const double speed_m_per_s : {0.5, 2.0, 20.0, 1e4}) {
    const Vector3d from(0.01, 0.0, 0.70);
    const Vector3d to(0.01, 0.0, 0.81);
    const double seconds = std::max(kTick_s, (to - from).norm() / speed_m_per_s);
    const Drive drove = drive_on(snapshot, line(from, to, seconds), seconds + 0.01);
    const testing::TrueFoot truth = bump->foot(drove.last.proxy.m);
    if (!drove.last.in_body || std::abs(truth.distance_m) > 1e-4)
      return AssertionFailure() << "tunnelled at " << speed_m_per_s << " m/s";
  }
  return all_of({{true, "held at 0.5, 2, 20 and 10000 m/s"}});
}

/// The outer shell of a torus whose tube is wider than its ring, as points with normals.
std::vector<CloudPoint> spindle() {
  std::vector<CloudPoint> points;
  constexpr double kRing = 0.01;
  constexpr double kTube = 0.02;
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 120; ++j) {
      const double a = 2.0 * M_PI * i / 120.0;
      const double b = 2.0 * M_PI * j / 120.0;
      const double across = kRing + kTube * std::cos(b);
      if (across < 0.0) continue;  // inside the union
      points.push_back({Vector3d(across * std::cos(a), across * std::sin(a), 0.8 + kTube * std::sin(b)).cast<float>(),
                        Vector3d(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)).cast<float>()});
    }
  return points;
}

AssertionResult spindle_torus() {
  const Drive side = drive_on(from_points(spindle()), line({0.05, 0, 0.8}, {0.02, 0, 0.8}, 0.2), 0.4);
  return all_of({{side.last.in_body, "in contact"},
                 below_m("on the outer shell", std::abs(side.last.proxy.m.x() - 0.03), 3e-4),
                 {side.last.normal.x() > 0.99, "normal outwards"}});
}

AssertionResult on_the_axis() {
  const Snapshot shell = from_points(spindle());
  const Drive first = drive_on(shell, line({0, 0, 0.75}, {0, 0, 0.8}, 0.2), 0.4);
  const Drive again = drive_on(shell, line({0, 0, 0.75}, {0, 0, 0.8}, 0.2), 0.4);
  return all_of({{first.finite, "finite"},
                 {first.last.normal == again.last.normal, "the same every time"},
                 {first.last.proxy.m == again.last.proxy.m, "the same proxy"}});
}

AssertionResult device_that_is_no_number() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  Touch touch;
  touch.adopt(*flat, at_s(1.0));
  (void)drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.1), 0.2);
  const TouchSample lost = touch.step({Vector3d::Constant(std::nan(""))}, at_s(1.2), kTick_s);
  const TouchSample back = touch.step({Vector3d(0, 0, 0.805)}, at_s(1.2005), kTick_s);
  return all_of({{!lost.valid && !lost.in_body && lost.proxy.m.allFinite(), "no answer, no NaN"},
                 {back.in_body, "contact goes on"}});
}

AssertionResult starts_in_the_body() {
  const Snapshot flat = from_depth([](int, int) { return 0.8; });
  const Drive shallow = drive_on(
      flat, [](double) { return Vector3d(0, 0, 0.81); }, 0.9);
  const Drive deep = drive_on(
      flat, [](double) { return Vector3d(0, 0, 0.9); }, 0.3);
  return all_of({below_N("the force grows from nothing", shallow.worst_step_N, kMostForceStep_N),
                 below_m("to all of it", std::abs(shallow.last.proxy.m.z() - 0.8), 1e-4),
                 {deep.worst_force_N == 0.0, "far behind is not in"}});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> shape_rows() {
  using namespace surface;
  return {
      {"8 concave crease", "two planes constrain the proxy", "two constraints, no chatter", concave_crease},
      {"9 medial axis", "the gradient vanishes", "the last valid plane is kept", vanishing_gradient},
      {"13 fast entry", "the surface lies between two ticks", "swept: no tunnelling at any real speed", fast_entry},
      {"14 torus, tube wider than ring", "the surface intersects itself", "point on the outer shell", spindle_torus},
      {"15 on the torus' axis", "all directions are equally near", "finite and deterministic", on_the_axis},
      {"33 device that is no number", "NaN spreads", "not valid, no NaN, contact continues", device_that_is_no_number},
      {"34 start in the body", "a sudden force", "grows from 0; deep behind is not inside", starts_in_the_body},
  };
}

}  // namespace telepalp::hard_cases
