#include <numbers>

#include "haptic_station/trials/trial_skin.h"

namespace telepalp::trials {
namespace {

/// A level surface whose prediction is exact: A (cos wt - 1) + B sin wt from the capture on.
class SinePlane final : public surface::SurfaceSnapshot {
 public:
  SinePlane(const device::BreathingPlane& plane, double time_s, double begins_s, std::uint64_t number, double camera_m)
      : z_m_(camera_m - plane.at_m(begins_s + time_s)) {
    captured = SessionTime{from_seconds(time_s)};
    sequence = number;
    points = 1;
    motion.moves = true;
    motion.breathing_rad_per_s = 2.0 * std::numbers::pi * plane.rate_hz;
    terms_[1] = plane.at_m(begins_s + time_s) - plane.height_m;
    terms_[2] = plane.speed_m_per_s(begins_s + time_s) / motion.breathing_rad_per_s;
  }

  [[nodiscard]] surface::FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d&,
                                              const surface::MotionBasis& basis) const noexcept override {
    surface::FieldSample sample;
    sample.valid = true;
    const double risen_m = terms_[1] * double{basis.value[1]} + terms_[2] * double{basis.value[2]};
    sample.f_m = z_m_ - risen_m - query.z();
    sample.gradient = sample.normal = -Eigen::Vector3d::UnitZ();
    sample.coverage = 1.0;
    sample.velocity_m_per_s = terms_[1] * double{basis.rate[1]} + terms_[2] * double{basis.rate[2]};
    return sample;
  }
  [[nodiscard]] std::optional<surface::Seed> seed(const Eigen::Vector3d& query) const noexcept override {
    return surface::Seed{{query.x(), query.y(), z_m_}, query.z() <= z_m_};
  }
  [[nodiscard]] double stride_m(const Eigen::Vector3d&) const noexcept override { return 0.05; }

 private:
  double z_m_;
  std::array<double, surface::kMotionTerms> terms_{};
};

class LevelSkin final : public TrialSkin {
 public:
  LevelSkin(const device::BreathingPlane& plane, double begins_s) : plane_(plane), begins_s_(begins_s) {}

  [[nodiscard]] const loop::TouchableSurface* newer(double time_s, const Point<HapticBase>&) override {
    if (time_s * kFrame_hz + 1e-9 < static_cast<double>(frames_)) return nullptr;
    const Transform<HapticBase, DepthCamera> placed = trial_camera();
    before_ = std::move(shown_.snapshot);
    shown_ = {std::make_shared<const SinePlane>(plane_, time_s, begins_s_, ++frames_, placed.iso.translation().y()),
              placed};
    return &shown_;
  }
  [[nodiscard]] double true_depth_m(const Point<HapticBase>& point, double time_s) const override {
    return plane_.at_m(begins_s_ + time_s) - point.m.y();
  }

 private:
  device::BreathingPlane plane_;
  double begins_s_;
  loop::TouchableSurface shown_;
  std::shared_ptr<const surface::SurfaceSnapshot> before_;  // shared: the loop refers to it until it gets `shown_`
  std::uint64_t frames_ = 0;
};

}  // namespace

Transform<HapticBase, DepthCamera> trial_camera(double height_m) noexcept {
  Transform<HapticBase, DepthCamera> placed;
  placed.iso.linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  placed.iso.translation() = Eigen::Vector3d{0.0, height_m, 0.0};
  return placed;
}

std::unique_ptr<TrialSkin> level_skin(const device::BreathingPlane& plane, double begins_s) {
  return std::make_unique<LevelSkin>(plane, begins_s);
}

}  // namespace telepalp::trials
