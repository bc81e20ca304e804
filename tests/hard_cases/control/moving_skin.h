#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "haptic_station/loop/haptic_loop.h"
#include "tests/hard_cases/control/felt.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/people.h"

namespace telepalp::hard_cases {

/// A skin of height y(x, t), seen at an instant: it knows its height and speed everywhere, and where it ends.
class MovingSkin final : public surface::SurfaceSnapshot {
 public:
  struct Shape {
    double flat_m = 0.0;
    double per_m = 0.0;  ///< slope of height over x
    double flat_m_per_s = 0.0;
    double turns_per_s = 0.0;  ///< slope of the speed over x
    double ends_at_x_m = 1e3;  ///< coverage falls from 1 to 0 over the last 10 mm
  };
  MovingSkin(const Shape& shape, SessionTime when) : shape_(shape) {
    captured = when;
    motion.moves = true;
  }
  [[nodiscard]] surface::FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d&,
                                              const surface::MotionBasis& basis) const noexcept override {
    surface::FieldSample sample;
    const double share = std::clamp((shape_.ends_at_x_m - query.x()) / 0.01, 0.0, 1.0);
    sample.coverage = share * share * (3.0 - 2.0 * share);
    if (sample.coverage <= 0.0) return {};
    sample.valid = true;
    const double risen_s = static_cast<double>(basis.value[0]);
    const double slope = shape_.per_m + shape_.turns_per_s * risen_s;
    const double up = 1.0 / std::sqrt(1.0 + slope * slope);
    sample.f_m = up * (query.y() - shape_.flat_m - shape_.flat_m_per_s * risen_s - slope * query.x());
    sample.gradient = sample.normal = up * Eigen::Vector3d(-slope, 1.0, 0.0);
    sample.velocity_m_per_s =
        up * static_cast<double>(basis.rate[0]) * (shape_.flat_m_per_s + shape_.turns_per_s * query.x());
    return sample;
  }
  [[nodiscard]] std::optional<surface::Seed> seed(const Eigen::Vector3d& query) const noexcept override {
    if (query.x() > shape_.ends_at_x_m) return std::nullopt;
    const double height_m = shape_.flat_m + shape_.per_m * query.x();
    return surface::Seed{{query.x(), height_m, query.z()}, query.y() >= height_m};
  }
  [[nodiscard]] double stride_m(const Eigen::Vector3d&) const noexcept override { return 0.05; }

 private:
  Shape shape_;
};

/// A moving skin felt through the live loop, with an exact camera of `frames_hz`.
struct MovingSkinScene {
  double seconds = 6.0;
  double frames_hz = 30.0;
  double delay_s = 0.0;  ///< from capture to adoption
  effects::EffectBank effects = the_skin();
  Person person = presses_to(0.03);
  std::function<MovingSkin::Shape(double now_s)> skin;
  std::function<void(const loop::TickOut&, double now_s)> watch = [](const auto&, double) {};
};

inline Felt feel(const MovingSkinScene& scene) {
  loop::HapticLoop loop({}, control::EncounteredController({}, scene.effects));
  device::SimulatedPair pair({}, {});
  pair.place({{0.0, 0.05, 0.0}}, {{0.0, 0.06, 0.0}});
  ShownSurface shown;
  Felt felt;
  int frames = 0;
  for (int tick = 0; tick * LoopScene::kTick_s < scene.seconds; ++tick) {
    const double now_s = tick * LoopScene::kTick_s;
    loop::TickIn in = in_of(pair, now_s);
    if (now_s * scene.frames_hz >= frames) {
      ++frames;
      const double captured_s = now_s - scene.delay_s;
      auto newer = std::make_shared<MovingSkin>(scene.skin(captured_s), at_s(captured_s));
      in.surface = shown.show({std::move(newer), {}});
    }
    if (tick % LoopScene::kTicksPerSample == 0) in.hand = {at_s(now_s), pair.true_hand()};
    const loop::TickOut act = loop.tick(in);
    const device::SimulatedPair before = pair;
    pair.step(act.force, scene.person({now_s, act.contact, pair.device()}), LoopScene::kTick_s);
    felt.add(act.control, before, pair, LoopScene::kTick_s);
    scene.watch(act, now_s);
  }
  return felt;
}

}  // namespace telepalp::hard_cases
