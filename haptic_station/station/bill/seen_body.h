#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"
#include "support/sensor/depth_sensor.h"

namespace telepalp::station {

/// A body that lies below a depth camera and breathes: the patient of `scene bill`. Its skin is known by a formula, in
/// the depth camera's frame: x to the image's right, y down the image, z away from the camera. The breaths differ from
/// each other and are no sum of a few harmonics, so no motion model of the station fits them exactly. The skin rests
/// for the first second.
class SeenBody {
 public:
  static constexpr double kFrames_per_s = 30.0;

  SeenBody();

  /// What a Kinect-like camera of 640x480 pixels sees at `time_s`, with its noise and its disparity steps.
  [[nodiscard]] DepthImage depth_at(double time_s) const;
  [[nodiscard]] const Intrinsics& camera() const noexcept { return camera_; }

  /// Depth z of the skin [m] over the point (x, y) [m] of the camera's frame.
  [[nodiscard]] double z_m(double x_m, double y_m, double time_s) const noexcept;
  /// How far the skin over y has moved since time 0, along -z (towards the camera) [m].
  [[nodiscard]] double risen_m(double y_m, double time_s) const noexcept;

 private:
  struct Pixel {
    float z_m = 0.0F;        ///< depth of the resting skin on this pixel's ray
    float per_risen = 0.0F;  ///< change of this depth, to first order, per metre that the belly rises
  };

  Intrinsics camera_{640, 480, 525.0, 525.0, 319.5, 239.5};
  sensor::DepthSensor sensor_;
  std::vector<Pixel> pixels_;
};

/// The true surface of a SeenBody at one instant, for the station's own touch: f is the distance to first order.
class TrueBody final : public surface::SurfaceSnapshot {
 public:
  TrueBody(const SeenBody& body, double time_s, SessionTime at) noexcept;

  [[nodiscard]] surface::FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                              const surface::MotionBasis& basis) const noexcept override;
  [[nodiscard]] std::optional<surface::Seed> seed(const Eigen::Vector3d& query) const noexcept override;
  [[nodiscard]] double stride_m(const Eigen::Vector3d&) const noexcept override { return 0.01; }

 private:
  const SeenBody& body_;
  double time_s_;
};

}  // namespace telepalp::station
