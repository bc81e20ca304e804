#include "tests/bench/delayed_skin.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/haptic_station/periods.h"

namespace telepalp::bench {
namespace {

constexpr double kBurst_frames = 4.0;
constexpr double kTau = 2.0 * std::numbers::pi;

SessionTime at(double time_s) { return SessionTime{from_seconds(time_s)}; }

double dot(const surface::MotionTerms& a, const surface::MotionTerms& b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  return sum;
}

}  // namespace

PlaneSnapshot::PlaneSnapshot(SessionTime captured_at, std::uint64_t number, double height_m,
                             const surface::MotionModel& model, const surface::MotionTerms& terms)
    : height_m_(height_m), terms_(terms) {
  captured = captured_at;
  sequence = number;
  motion = model;
}

surface::FieldSample PlaneSnapshot::evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d&,
                                             const surface::MotionBasis& basis) const noexcept {
  surface::FieldSample sample;
  sample.valid = true;
  sample.f_m = query.y() - height_m_ - dot(terms_, basis.value);
  sample.gradient = sample.normal = Eigen::Vector3d::UnitY();
  sample.coverage = 1.0;
  sample.velocity_m_per_s = dot(terms_, basis.rate);
  return sample;
}

std::optional<surface::Seed> PlaneSnapshot::seed(const Eigen::Vector3d& query) const noexcept {
  return surface::Seed{{query.x(), height_m_, query.z()}, query.y() >= height_m_};
}

void SkinMotion::add(double time_s, double height_m) {
  const double dt = time_s - last_s_;
  if (last_s_ < 0.0 || dt > 0.5) {
    height_m_ = height_m;
    speed_ = 0.0;
  } else {
    constexpr double kG = 0.5;
    constexpr double kH = 0.1;
    const double surprise = height_m - height_m_ - speed_ * dt;
    height_m_ += speed_ * dt + kG * surprise;
    speed_ += kH * surprise / dt;
  }
  last_s_ = time_s;
  recent_.push_back({time_s, height_m});
  while (time_s - recent_.front().time_s > 8.0) recent_.pop_front();
  fit_breath();
}

/// Least squares of 1, cos, sin of the breath's phase over the window, the phase counted from the newest moment.
SkinMotion::Fit SkinMotion::fit_at(double rad_per_s) const {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double square = 0.0;
  for (const Moment& moment : recent_) {
    const double phase = rad_per_s * (moment.time_s - last_s_);
    const Eigen::Vector3d row{1.0, std::cos(phase), std::sin(phase)};
    normal += row * row.transpose();
    right += row * moment.height_m;
    square += moment.height_m * moment.height_m;
  }
  const Eigen::Vector3d c = normal.ldlt().solve(right);
  const double left = std::max(0.0, square - c.dot(right));
  return {c, std::sqrt(left / static_cast<double>(recent_.size()))};
}

/// Searches the rate once a second and fits at this rate with every frame. The model is locked when the residual is
/// small.
void SkinMotion::fit_breath() {
  locked_ = false;
  if (last_s_ - recent_.front().time_s < 6.0) return;
  if (--until_search_ <= 0) {
    until_search_ = 30;
    double least_m = std::numeric_limits<double>::infinity();
    for (double hz = 0.15; hz < 0.5; hz *= 1.01) {
      const double unexplained_m = fit_at(kTau * hz).unexplained_m;
      if (unexplained_m < least_m) rad_per_s_ = kTau * hz;
      least_m = std::min(least_m, unexplained_m);
    }
    for (double step = 0.005; step > 1e-4;
         step /= 2.0)  // an error of 1 % would still cause 0.15 mm at the window's end
      for (const double rate : {rad_per_s_ * (1.0 - step), rad_per_s_ * (1.0 + step)})
        if (fit_at(rate).unexplained_m < fit_at(rad_per_s_).unexplained_m) rad_per_s_ = rate;
  }
  const Fit fit = fit_at(rad_per_s_);
  cosine_m_ = fit.c[1];
  sine_m_ = fit.c[2];
  locked_ = std::hypot(cosine_m_, sine_m_) > 5.0 * fit.unexplained_m;
  if (locked_) height_m_ = fit.c[0] + fit.c[1];
}

surface::MotionModel SkinMotion::model() const noexcept {
  surface::MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = rad_per_s_;
  return model;
}

surface::MotionTerms SkinMotion::terms() const noexcept {
  if (!locked_) return {static_cast<float>(speed_), 0.0F, 0.0F, 0.0F, 0.0F};
  return {0.0F, static_cast<float>(cosine_m_), static_cast<float>(sine_m_), 0.0F, 0.0F};
}

DelayedSkin::DelayedSkin(const device::BreathingPlane& truth, double noise_m, LinkFaults faults, std::uint64_t seed)
    : truth_(truth), noise_m_(noise_m), faults_(std::move(faults)), random_(seed), loss_(faults_.loss, kBurst_frames) {}

void DelayedSkin::capture(double time_s) {
  const bool lost = loss_.lost(random_.uniform());
  const double height_m = truth_.at_m(time_s) + noise_m_ * random_.normal();
  double arrives_s = time_s + std::max(0.0, faults_.one_way_s + random_.uniform(-faults_.jitter_s, faults_.jitter_s));
  for (const auto& [from, to] : faults_.outages)
    if (arrives_s >= from && arrives_s < to) arrives_s = to;
  if (!lost) on_the_way_.push_back({time_s, arrives_s, height_m});
}

/// Takes the newest frame that has arrived; older ones are dropped.
void DelayedSkin::receive(double time_s) {
  std::sort(on_the_way_.begin(), on_the_way_.end(),
            [](const Frame& a, const Frame& b) { return a.arrives_s < b.arrives_s; });
  const Frame* newest = nullptr;
  std::size_t arrived = 0;
  while (arrived < on_the_way_.size() && on_the_way_[arrived].arrives_s <= time_s) {
    const Frame& frame = on_the_way_[arrived++];
    if (frame.captured_s > newest_s_ && (newest == nullptr || frame.captured_s > newest->captured_s)) newest = &frame;
  }
  if (newest != nullptr) {
    newest_s_ = newest->captured_s;
    motion_.add(newest->captured_s, newest->height_m);
    auto next = std::make_unique<PlaneSnapshot>(at(newest->captured_s), ++sequence_, motion_.height_m(),
                                                motion_.model(), motion_.terms());
    touch_.adopt(*next, at(time_s));
    snapshot_ = std::move(next);
  }
  on_the_way_.erase(on_the_way_.begin(), on_the_way_.begin() + static_cast<std::ptrdiff_t>(arrived));
}

ports::SurfaceContact DelayedSkin::touch(const Point<HapticBase>& device, double time_s, double dt_s) {
  if (time_s >= next_capture_s_) {
    capture(time_s);
    next_capture_s_ += kFrame_s;
  }
  if (!on_the_way_.empty()) receive(time_s);
  const surface::TouchSample sample = touch_.step({device.m}, at(time_s), dt_s);
  return {.proxy = {sample.proxy.m},
          .normal = {sample.normal},
          .distance_m = sample.distance_m,
          .in_body = sample.in_body,
          .valid = sample.valid,
          .surface_speed_m_per_s = sample.surface_velocity_m_per_s,
          .age_s = snapshot_ ? sample.age_s : std::numeric_limits<double>::infinity()};
}

}  // namespace telepalp::bench
