#include <algorithm>
#include <memory>

#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

constexpr double kMostDamping_N_s_per_m = 40.0;  // of the passivity controller; it multiplies the surface's speed

/// A level skin with a stated speed.
class MovingPlane final : public SurfaceSnapshot {
 public:
  MovingPlane(double z_m, double speed_m_per_s, SessionTime when) : z_m_(z_m), speed_m_per_s_(speed_m_per_s) {
    captured = when;
    motion.moves = true;
  }
  [[nodiscard]] FieldSample evaluate(const Vector3d& query, const Vector3d&,
                                     const MotionBasis& basis) const noexcept override {
    FieldSample sample;
    sample.valid = true;
    sample.f_m = z_m_ - speed_m_per_s_ * static_cast<double>(basis.value[0]) - query.z();
    sample.gradient = sample.normal = -Vector3d::UnitZ();
    sample.coverage = 1.0;
    sample.velocity_m_per_s = speed_m_per_s_ * static_cast<double>(basis.rate[0]);
    return sample;
  }
  [[nodiscard]] std::optional<Seed> seed(const Vector3d& query) const noexcept override {
    return Seed{{query.x(), query.y(), z_m_}, query.z() <= z_m_};
  }
  [[nodiscard]] double stride_m(const Vector3d&) const noexcept override { return 0.05; }

 private:
  double z_m_;
  double speed_m_per_s_;
};

struct Followed {
  double reaches_90_s = 1e9;
  double beyond_m = 0.0;      ///< overshoot
  double worst_step_N = 0.0;  ///< largest change of the spring's force in a tick
  double worst_kick_N = 0.0;  ///< largest change in a tick of the greatest damping on the published speed
};

using Skin = std::function<std::pair<double, double>(int swap, double t)>;  // z and speed

/// A device 20 mm deep in a skin at 0.8 m. From 0.5 s on, `skin` gives the position and speed at each swap.
Followed follow(double swaps_hz, double step_m, const Skin& skin) {
  Followed got;
  Touch touch;
  std::shared_ptr<MovingPlane> shown = std::make_shared<MovingPlane>(0.8, 0.0, at_s(0.5));
  touch.adopt(*shown, at_s(0.5));
  (void)drive(
      touch, line({0, 0, 0.79}, {0, 0, 0.82}, 0.3), 0.5, [](double) { return nullptr; }, -0.5);
  double last_N = kStiffness_N_per_m * 0.02;
  double last_speed = 0.0;
  int swaps = 0;
  for (int tick = 0; tick * kTick_s < 3.0; ++tick) {
    const double t = tick * kTick_s;
    if (t * swaps_hz >= swaps) {
      const auto [z_m, speed] = skin(swaps++, t);
      auto newer = std::make_shared<MovingPlane>(z_m, speed, at_s(1.0 + t));
      touch.adopt(*newer, at_s(1.0 + t));
      shown = std::move(newer);
    }
    const TouchSample felt = touch.step({{0, 0, 0.82}}, at_s(1.0 + t), kTick_s);
    const double force_N = kStiffness_N_per_m * (0.82 - felt.proxy.m.z());
    const double risen_m = 0.8 - felt.proxy.m.z();
    if (risen_m >= 0.9 * step_m) got.reaches_90_s = std::min(got.reaches_90_s, t);
    got.beyond_m = std::max(got.beyond_m, risen_m - step_m);
    got.worst_step_N = std::max(got.worst_step_N, std::abs(force_N - last_N));
    got.worst_kick_N =
        std::max(got.worst_kick_N, kMostDamping_N_s_per_m * std::abs(felt.surface_velocity_m_per_s - last_speed));
    last_N = force_N;
    last_speed = felt.surface_velocity_m_per_s;
  }
  return got;
}

AssertionResult step_at_any_swap_rate() {
  Followed worst;
  worst.reaches_90_s = 0.0;
  double quickest_s = 1e9;
  for (const double hz : {0.1, 10.0, 30.0, 60.0, 100.0, 200.0}) {
    const Followed got = follow(hz, 0.01, [](int, double) { return std::pair(0.79, 0.0); });
    worst.reaches_90_s = std::max(worst.reaches_90_s, got.reaches_90_s);
    quickest_s = std::min(quickest_s, got.reaches_90_s);
    worst.beyond_m = std::max(worst.beyond_m, got.beyond_m);
    worst.worst_step_N = std::max(worst.worst_step_N, got.worst_step_N);
    worst.worst_kick_N = std::max(worst.worst_kick_N, got.worst_kick_N);
  }
  return all_of({below("90 %", worst.reaches_90_s, 0.6, 1.0, "s"),
                 below("whatever the rate: differs by", worst.reaches_90_s - quickest_s, 0.02, 1e3, "ms"),
                 below_m("overshoot", worst.beyond_m, 2e-4), below_N("step", worst.worst_step_N, 0.05),
                 below_N("damping's step", worst.worst_kick_N, 0.05)});
}

/// Each swap states another speed, as under noise.
AssertionResult speed_that_jumps() {
  const Followed got = follow(30.0, 1.0, [](int swap, double) { return std::pair(0.8, swap % 2 == 0 ? 0.02 : -0.02); });
  return all_of({below_N("step", got.worst_step_N, 0.05), below_N("damping's step", got.worst_kick_N, 0.05)});
}

/// A snapshot with an absurd speed, as from a cell that saw a passing sleeve.
AssertionResult absurd_speed() {
  const Followed got = follow(30.0, 0.0, [](int swap, double) { return std::pair(0.8, swap == 10 ? 3.0 : 0.0); });
  return all_of({below_N("step", got.worst_step_N, 0.1), below_N("damping's step", got.worst_kick_N, 0.05),
                 below("rises by", got.beyond_m, 0.01, 1e3, "mm")});
}

/// A true motion with a good prediction: the displayed surface must not lag.
AssertionResult steady_rise() {
  const Followed got = follow(30.0, 0.02, [](int, double t) {
    const double moving_s = std::min(t, 1.0);
    return std::pair(0.8 - 0.02 * moving_s, t < 1.0 ? 0.02 : 0.0);
  });
  return all_of({below("90 % of 20 mm in 1 s", got.reaches_90_s, 0.95, 1.0, "s"),
                 below_m("overshoot", got.beyond_m, 5e-4), below_N("step", got.worst_step_N, 0.05),
                 below_N("damping's step", got.worst_kick_N, 0.05)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> follow_rows() {
  using namespace surface;
  return {
      {"10 mm step, swaps at 0.1 to 200 Hz", "a slew that restarts at each swap", "90 % in 0.6 s at any rate",
       step_at_any_swap_rate},
      {"speeds that jump at swaps", "damping multiplies a step of speed", "the published speed is continuous",
       speed_that_jumps},
      {"a snapshot with an absurd speed", "3 m/s for one frame", "bounded speed and acceleration", absurd_speed},
      {"steady rise, well predicted", "a filter that lags", "no lag, no overshoot", steady_rise},
  };
}

}  // namespace telepalp::hard_cases
