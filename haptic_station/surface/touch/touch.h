#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/touch/proxy.h"
#include "haptic_station/surface/touch/slew.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::surface {

struct TouchSettings {
  SlewSettings slew;
  int most_iterations = 4;        ///< of the proxy in one step; each costs one evaluation
  double settle_m = 2e-5;         ///< steps shorter than this need no second look: their error is their square
  double longest_hop_m = 0.004;   ///< of the device between two looks; a longer move is swept in parts
  double deepest_start_m = 0.05;  ///< a device first met deeper than this is behind the surface, not in it
  bool slewed_start = true;       ///< a device first met in the body sinks in slowly instead of at once
  double off_foot_m = 0.004;      ///< a device farther than this to the side of its foot is beyond the rim
  double stale_after_s = 1.0;     ///< age of the snapshot at which the proxy begins to let go
  double let_go_over_s = 0.5;     ///< and the time it takes to
};

/// One step's answer, in the depth camera's frame.
struct TouchSample {
  bool valid = false;        ///< false: no surface in reach (or it is stale): no contact, no distance
  bool in_body = false;      ///< the device is below the displayed surface, having come from outside
  Point<DepthCamera> proxy;  ///< on the surface while in the body, else the device. k·(proxy − device) is the
                             ///< force: it fades by itself at rims, over holes and with age
  Point<DepthCamera> foot;   ///< the surface point nearest to the device that the search follows
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, out of the body, at the foot; zero when not valid
  double distance_m = 0.0;                           ///< signed, of the device from the foot; negative in the body
  double surface_velocity_m_per_s = 0.0;             ///< of the displayed surface at the foot, along the normal
  double uncertainty_m = 0.0;                        ///< 1-sigma of the surface's place: noise, fit and prediction
  double support = 0.0;                              ///< 1 well inside known surface, 0 where it ends or is stale
  double age_s = 0.0;                                ///< since the snapshot's capture, and at least since its adoption
};

/// By how much the displayed surface at the foot differs from the newest snapshot as it was captured, outwards
/// positive.
struct Displaced {
  double carried_m = 0.0;  ///< by prediction, over the snapshot's age
  double slewed_m = 0.0;   ///< what is left of the last snapshot's step: the displayed surface has yet to sink by it
};

/// The touch of one device point: owns the proxy, carries the surface forward and slews new snapshots in.
/// Owner: the haptic thread. step() and adopt() neither allocate, lock, throw nor call the system, as long as the
/// snapshot says realtime_safe().
class Touch {
 public:
  explicit Touch(const TouchSettings& settings = {}) noexcept : settings_(settings) {}

  /// `snapshot` takes over, slewed. It must stay alive until the next adopt() or release(); the one before is not
  /// looked at again. One that is not newer (the builder drops those) is counted.
  void adopt(const SurfaceSnapshot& snapshot, SessionTime now) noexcept;
  /// Forgets the snapshot and lets go at once.
  void release() noexcept;
  /// Where the device is now; `dt_s` since the last step. A position that is not finite changes nothing and is answered
  /// with valid = false; time that goes back is taken as standing still.
  [[nodiscard]] TouchSample step(const Point<DepthCamera>& device, SessionTime now, double dt_s) noexcept;

  /// Looks twice at the surface; zero without a foot.
  [[nodiscard]] Displaced displaced() const noexcept;

  [[nodiscard]] std::uint64_t out_of_order() const noexcept { return out_of_order_; }

 private:
  enum class Side { Unknown, Outside, Inside };

  [[nodiscard]] FieldSample field(const Eigen::Vector3d& at) const noexcept;
  [[nodiscard]] FieldSample field_at_foot() noexcept;
  [[nodiscard]] FieldSample farthest_known(Eigen::Vector3d& goal) const noexcept;
  void look(const Eigen::Vector3d& device) noexcept;
  void reseed(const Eigen::Vector3d& device) noexcept;
  void meet_again() noexcept;
  void follow(const Eigen::Vector3d& device) noexcept;
  void decide(const Eigen::Vector3d& device) noexcept;
  void sink_in_slowly(const Eigen::Vector3d& device) noexcept;
  void hold(double dt_s, const Eigen::Vector3d& device) noexcept;
  [[nodiscard]] double height_of(const Eigen::Vector3d& device) const noexcept;
  [[nodiscard]] double sideways_of(const Eigen::Vector3d& device) const noexcept;
  [[nodiscard]] double age_s() const noexcept;
  [[nodiscard]] double freshness() const noexcept;
  [[nodiscard]] TouchSample answer(const Eigen::Vector3d& device) const noexcept;

  TouchSettings settings_;
  const SurfaceSnapshot* snapshot_ = nullptr;  // borrowed
  SessionTime snapshot_captured_{};            // its own copy: the one before is gone when the next comes
  SessionTime adopted_{};
  Slew slew_;
  MotionBasis basis_;
  SessionTime now_{};
  Side side_ = Side::Unknown;
  bool has_foot_ = false;
  bool swapped_ = false;  // a new snapshot, not looked at yet
  FieldSample at_foot_;   // displayed, at foot_
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  // last valid one
  Eigen::Vector3d device_ = Eigen::Vector3d::Zero();  // of the last step
  bool has_device_ = false;
  double slide_ = 1.0;  // share of the tangential step that the curvature under the proxy allows
  double held_ = 0.0;   // how much of the contact is shown: follows the support, never in a step
  std::uint64_t out_of_order_ = 0;
};

}  // namespace telepalp::surface
