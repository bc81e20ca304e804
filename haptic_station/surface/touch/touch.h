#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/touch/proxy.h"
#include "haptic_station/surface/touch/surface_follower.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::surface {

struct TouchSettings {
  FollowLimits follow;
  int most_iterations = 4;         ///< of the proxy in one step; each costs one evaluation
  double settle_m = 2e-5;          ///< steps shorter than this need no second look: their error is their square
  double longest_hop_m = 0.004;    ///< of the device between two looks; a longer move is swept in parts
  double deepest_start_m = 0.09;   ///< a device first met deeper than this is behind the surface, not in it
  bool gentle_start = true;        ///< a device first met in the body is shown the skin where it is, which then rises
  double other_surface_m = 0.045;  ///< a surface that steps farther than this under a contact is another one
  double off_foot_m = 0.004;       ///< a device farther than this to the side of its foot is beyond the rim
  double stale_after_s = 1.0;      ///< age of the snapshot at which the proxy begins to let go
  double let_go_over_s = 0.5;      ///< and the time it takes to
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
  double newest_above_m = 0.0;           ///< of the newest surface, carried to now, over the displayed one at the foot
  double newest_velocity_m_per_s = 0.0;  ///< of the newest surface there, along the normal
  Eigen::Vector3d anchor_velocity_m_per_s = Eigen::Vector3d::Zero();  ///< of the displayed surface where the contact
                                                                      ///< began; zero out of the body
  double uncertainty_m = 0.0;  ///< 1-sigma of the surface's place: noise, fit and prediction
  double support = 0.0;        ///< 1 well inside known surface, 0 where it ends or is stale
  double age_s = 0.0;          ///< since the snapshot's capture, and at least since its adoption
};

/// By how much the displayed surface at the foot differs from the newest snapshot as it was captured, outwards
/// positive.
struct Displaced {
  double carried_m = 0.0;  ///< by prediction, over the snapshot's age
  double slewed_m = 0.0;   ///< by which the displayed surface has yet to sink to the newest
};

/// The touch of one device point: owns the proxy, carries the surface forward and follows new snapshots gently.
///
/// The side of the skin is seen: a device below the displayed surface is in the body. Where no surface is displayed, at
/// the start or after the contact had to let go, the newest image says on which side the device is; if it is in the
/// body, the skin is shown at the device first and rises from there. What is remembered is that a device came round a
/// rim or behind a silhouette, or to the back of a thin sheet: then it is not in the body, though behind what is seen.
/// Owner: the haptic thread. step() and adopt() neither allocate, lock, throw nor call the system, as long as the
/// snapshot says realtime_safe().
class Touch {
 public:
  explicit Touch(const TouchSettings& settings = {}) noexcept : settings_(settings) {}

  /// `snapshot` takes over, without a step. It must stay alive until the next adopt() or release(); the one before is
  /// not looked at again. One that is not newer (the builder drops those) is counted.
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
  [[nodiscard]] FieldSample meet(const Eigen::Vector3d& expected) noexcept;
  [[nodiscard]] FieldSample farthest_known(Eigen::Vector3d& goal) const noexcept;
  void carry_on(double dt_s) noexcept;
  void look(const Eigen::Vector3d& device) noexcept;
  void reseed(const Eigen::Vector3d& device) noexcept;
  void follow(const Eigen::Vector3d& device) noexcept;
  void decide(const Eigen::Vector3d& device) noexcept;
  void show_at(const Eigen::Vector3d& device) noexcept;
  void follow_anchor(double dt_s) noexcept;
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
  SurfaceFollower follower_{settings_.follow};
  MotionBasis basis_;
  SessionTime now_{};
  Side side_ = Side::Unknown;
  bool has_foot_ = false;
  bool fresh_foot_ = false;     // of a reseed: the newest surface is displayed as it is
  bool swapped_ = false;        // a new snapshot, not looked at yet
  bool was_in_front_ = false;   // at the last look: going in from there is going through the skin
  FieldSample at_foot_;         // displayed, at foot_
  double newest_velocity_ = 0;  // of the newest surface there [m/s]
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  // last valid one
  Eigen::Vector3d device_ = Eigen::Vector3d::Zero();  // of the last step
  bool has_device_ = false;
  bool anchored_ = false;
  LineFollower anchor_{settings_.follow};                    // the displayed skin where the contact began
  Eigen::Vector3d newest_anchor_ = Eigen::Vector3d::Zero();  // where the newest surface crosses its line
  double anchor_speed_ = 0.0;                                // over the last step [m/s]
  double slide_ = 1.0;  // share of the tangential step that the curvature under the proxy allows
  double held_ = 0.0;   // how much of the contact is shown: follows the support, never in a step
  std::uint64_t out_of_order_ = 0;
};

}  // namespace telepalp::surface
