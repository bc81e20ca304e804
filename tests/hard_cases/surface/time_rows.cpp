#include <random>

#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

DepthImage flat_image(double z_m) {
  const Intrinsics camera = small_camera();
  return {.width = camera.width,
          .height = camera.height,
          .unit_m = 2e-5,
          .samples = std::vector<std::uint16_t>(static_cast<std::size_t>(camera.width * camera.height),
                                                static_cast<std::uint16_t>(std::lround(z_m / 2e-5)))};
}

AssertionResult clock_jumps() {
  SurfaceBuilder builder{SurfaceSettings{}};
  const DepthImage image = flat_image(0.8);
  const auto first = builder.add(image, small_camera(), at_s(10.0), std::nullopt);
  const bool duplicate = builder.add(image, small_camera(), at_s(10.0), std::nullopt) == nullptr;
  const bool older = builder.add(image, small_camera(), at_s(9.9), std::nullopt) == nullptr;
  Touch touch;
  touch.adopt(*first, at_s(10.0));
  bool finite = true;
  for (const double t : {10.1, 9.0, 10.2, -5.0})
    finite = finite && touch.step({{0, 0, 0.803}}, at_s(t), t < 10 ? -1.0 : 0.0005).proxy.m.allFinite();
  return all_of({{duplicate && older && builder.counts().not_newer == 2, "dropped and counted"}, {finite, "finite"}});
}

/// A flat patient that breathes ±2.5 mm at 0.25 Hz, seen at 30 Hz with its stamps `jitter_s` off.
Drive breathe(double jitter_s, const std::function<bool(double)>& outage, double until_s) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> jitter(-jitter_s, jitter_s);
  SurfaceBuilder builder{SurfaceSettings{}};
  Snapshot current;
  int next = 0;
  Touch touch;
  const auto feed = [&](double t) -> const SurfaceSnapshot* {
    if (t * 30.0 < next) return nullptr;
    next = static_cast<int>(t * 30.0) + 1;
    if (outage(t)) return nullptr;
    const DepthImage image = flat_image(0.8 + 0.0025 * std::cos(0.5 * M_PI * t));
    if (auto built = builder.add(image, small_camera(), at_s(1.0 + t + jitter(random)), std::nullopt)) current = built;
    return current.get();
  };
  return drive(
      touch, [](double t) { return Vector3d(0, 0, 0.78 + 0.03 * std::min(1.0, 2.0 * t)); }, until_s, feed);
}

AssertionResult jittered_frames() {
  const Drive drove = breathe(
      0.004, [](double) { return false; }, 6.0);
  return all_of({{drove.finite && drove.last.in_body, "in contact"},
                 below_N("no step beyond the hand's own motion", drove.worst_step_N, 0.04)});
}

AssertionResult swap_in_contact() {
  const Snapshot before = from_depth([](int, int) { return 0.8; });
  const Snapshot after = from_depth([](int, int) { return 0.797; }, at_s(1.3));
  Touch touch;
  touch.adopt(*before, at_s(1.0));
  const Drive sunk = drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 0.3);
  bool adopted = false;
  const auto feed = [&](double) { return std::exchange(adopted, true) ? nullptr : after.get(); };
  const Drive swapped = drive(
      touch, [](double) { return Vector3d(0, 0, 0.805); }, 1.0, feed, 0.3);
  return all_of({{sunk.last.in_body, "in contact"},
                 below_N("slewed", swapped.worst_step_N, kMostForceStep_N),
                 below_m("and it arrives", std::abs(swapped.last.proxy.m.z() - 0.797), 2e-5)});
}

AssertionResult burst() {
  std::vector<Snapshot> queued;
  for (int i = 0; i < 15; ++i)
    queued.push_back(from_depth([=](int, int) { return 0.8 - 0.0002 * i; }, at_s(1.0 + 0.033 * i)));
  Touch touch;
  touch.adopt(*queued.front(), at_s(1.0));
  (void)drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 0.5);
  bool came = false;
  const auto feed = [&](double t) -> const SurfaceSnapshot* {
    if (std::exchange(came, true)) return nullptr;
    for (const Snapshot& one : queued) touch.adopt(*one, at_s(1.0 + t));
    return nullptr;
  };
  const Drive after = drive(
      touch, [](double) { return Vector3d(0, 0, 0.805); }, 0.7, feed, 0.5);
  return all_of({below_N("no step", after.worst_step_N, kMostForceStep_N),
                 below_m("only the newest counts", std::abs(after.last.proxy.m.z() - (0.8 - 0.0028)), 2e-5)});
}

AssertionResult outage() {
  const Snapshot only = from_depth([](int, int) { return 0.8; });
  Touch touch;
  touch.adopt(*only, at_s(1.0));
  const Drive drove = drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.2), 3.0);
  return all_of({{drove.touched, "was in contact"},
                 {!drove.last.valid && (drove.last.proxy.m - Vector3d(0, 0, 0.805)).norm() == 0.0, "has let go"},
                 below_N("without a step", drove.worst_step_N, kMostForceStep_N)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> time_rows() {
  using namespace surface;
  return {
      {"20 clock jump, duplicate", "time goes back", "dropped, counted, monotone", clock_jumps},
      {"21 jittered frames", "wrong intervals give wrong velocities", "bounded, no step", jittered_frames},
      {"22 surface swap in contact", "a jump would give the hand energy", "gradual, and it arrives", swap_in_contact},
      {"23 burst after an outage", "old frames come late", "newest only, no step", burst},
      {"24 outage", "an old surface may be wrong", "the force decays to zero at the age limit", outage},
  };
}

}  // namespace telepalp::hard_cases
