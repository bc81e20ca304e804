#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/device/random.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/touch/touch.h"
#include "proto/impaired/gilbert_elliott.h"

namespace telepalp::bench {

/// Faults of the network. Losses follow the model of Gilbert and Elliott: bursts of four frames on average.
struct LinkFaults {
  double one_way_s = 0.0;
  double jitter_s = 0.0;  ///< uniform, in both directions
  double loss = 0.0;      ///< share of frames
  std::vector<std::pair<double, double>>
      outages;  ///< begin and end; the frames sent meanwhile arrive in a burst at the end
};

/// A level surface that moves as a snapshot's motion model says; the frame that Touch works in has y up here.
class PlaneSnapshot final : public surface::SurfaceSnapshot {
 public:
  PlaneSnapshot(SessionTime captured_at, std::uint64_t number, double height_m, const surface::MotionModel& model,
                const surface::MotionTerms& terms);
  [[nodiscard]] surface::FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                              const surface::MotionBasis& basis) const noexcept override;
  [[nodiscard]] std::optional<surface::Seed> seed(const Eigen::Vector3d& query) const noexcept override;
  [[nodiscard]] double stride_m(const Eigen::Vector3d&) const noexcept override { return 0.05; }

 private:
  double height_m_;
  surface::MotionTerms terms_;
};

/// Learns a level skin's motion from its heights: velocity by a g-h filter, and the breath by least squares over the
/// last eight seconds once it explains them.
class SkinMotion {
 public:
  void add(double time_s, double height_m);
  [[nodiscard]] double height_m() const noexcept { return height_m_; }
  [[nodiscard]] surface::MotionModel model() const noexcept;
  [[nodiscard]] surface::MotionTerms terms() const noexcept;

 private:
  struct Moment {
    double time_s;
    double height_m;
  };
  struct Fit {
    Eigen::Vector3d c;  ///< coefficients of 1, cos, sin
    double unexplained_m;
  };
  [[nodiscard]] Fit fit_at(double rad_per_s) const;
  void fit_breath();

  std::deque<Moment> recent_;
  double height_m_ = 0.0;
  double speed_ = 0.0;
  double last_s_ = -1.0;
  int until_search_ = 0;
  bool locked_ = false;
  double rad_per_s_ = 0.0;
  double cosine_m_ = 0.0;  ///< cosine of the breath; phase 0 is the newest frame
  double sine_m_ = 0.0;
};

/// The true skin, a camera at 30 Hz, the link, and the station's Touch.
class DelayedSkin {
 public:
  DelayedSkin(const device::BreathingPlane& truth, double noise_m, LinkFaults faults, std::uint64_t seed);

  /// The station's contact at this tick.
  [[nodiscard]] ports::SurfaceContact touch(const Point<HapticBase>& device, double time_s, double dt_s);

 private:
  struct Frame {
    double captured_s;
    double arrives_s;
    double height_m;
  };
  void capture(double time_s);
  void receive(double time_s);

  device::BreathingPlane truth_;
  double noise_m_;
  LinkFaults faults_;
  device::Random random_;
  surface::Touch touch_;
  SkinMotion motion_;
  std::deque<Frame> on_the_way_;
  std::unique_ptr<PlaneSnapshot> snapshot_;
  double next_capture_s_ = 0.0;
  double newest_s_ = -1.0;
  std::uint64_t sequence_ = 0;
  impaired::GilbertElliott loss_;
};

}  // namespace telepalp::bench
