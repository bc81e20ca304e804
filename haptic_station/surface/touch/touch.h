#pragma once

#include <Eigen/Core>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/touch/proxy.h"
#include "haptic_station/surface/touch/surface_follower.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::surface {

/// Time over which a contact fades after its surface is stale or lost.
inline constexpr double kLetGoOver_s = 0.5;
/// A device first seen deeper than this is behind the surface, not in the body.
inline constexpr double kDeepestStart_m = 0.09;

struct TouchSettings {
  bool gentle_start = true;    ///< skin over a device first seen in the body is displayed at the device, then rises
  double stale_after_s = 1.0;  ///< age of the snapshot at which the contact begins to fade
};

/// The result of one step, in the depth camera's frame.
struct TouchSample {
  bool valid = false;        ///< false: no surface in reach, or a stale one; there is no contact and no distance
  bool in_body = false;      ///< the device is below the displayed surface, and not behind a rim or a sheet
  Point<DepthCamera> proxy;  ///< in the body: device + coverage · (foot − device); else: the device. So a spring
                             ///< k·(proxy − device) fades at rims, over holes and with age
  Point<DepthCamera> foot;   ///< the surface point nearest to the device; the device itself when not valid
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, out of the body, at the foot; zero when not valid
  double distance_m = 0.0;                ///< signed distance of the device from the foot; negative in the body
  double surface_velocity_m_per_s = 0.0;  ///< speed of the displayed surface at the foot, along the normal
  double newest_above_m = 0.0;  ///< height of the newest surface, predicted to now, over the displayed one at the foot
  double newest_velocity_m_per_s = 0.0;  ///< speed of the newest surface at the foot, along the normal
  Eigen::Vector3d anchor_velocity_m_per_s = Eigen::Vector3d::Zero();  ///< of the displayed skin where contact began
  double uncertainty_m = 0.0;  ///< standard deviation of the surface's position, from noise, fit and prediction
  double coverage = 0.0;       ///< factor on the contact's force: 1 well inside, 0 where the surface ends or is stale
  double unmodelled = 0.0;     ///< MotionModel::unmodelled of the snapshot, 0 to 1
  double age_s = 0.0;          ///< time since the snapshot's capture or its adoption, whichever is longer
};

/// Displacement of the displayed surface, at the foot, from the newest snapshot as captured. Both parts are measured
/// along the normal, positive out of the body.
struct Displaced {
  double carried_m = 0.0;  ///< part due to prediction over the snapshot's age
  double slewed_m = 0.0;   ///< part due to the gradual change of snapshots: displayed minus newest surface
};

/// The touch of one device point: finds the foot, the surface point nearest to the device, and the proxy, predicts the
/// surface from its capture to now, and changes gradually to new snapshots.
///
/// A device below the displayed surface is in the body. At the start, or after a release, no surface is displayed; then
/// the newest snapshot decides on which side of the skin the device is. If the device is in the body, the skin is first
/// displayed at the device and rises from there (TouchSettings::gentle_start). The side is remembered from step to
/// step: a device that went round a rim, behind a silhouette or to the back of a thin sheet is behind the visible
/// surface but not in the body. Owner: the haptic thread. step() and adopt() neither allocate, lock, throw nor call the
/// system, if the snapshot is realtime_safe().
class Touch {
 public:
  explicit Touch(const TouchSettings& settings = {}, const FollowLimits& follow = {}) noexcept
      : settings_(settings), follow_(follow) {}

  /// Uses `snapshot` from now on; the displayed surface does not jump. The snapshot must stay alive until the next
  /// adopt() or release(). The earlier snapshot is not read again. A snapshot that is not newer than the last one is
  /// used all the same and counted in out_of_order().
  void adopt(const SurfaceSnapshot& snapshot, SessionTime now) noexcept;
  /// Forgets the snapshot and ends the contact at once.
  void release() noexcept;
  /// The touch at `now`, `dt_s` after the last step. A position that is not finite moves nothing and gives an empty
  /// sample, as does a step without a snapshot. If `now` goes back, the latest `now` so far counts. `felt`: the skin
  /// gave force at the last tick; if not, the coverage may rise at once, and a contact below kDeepestStart_m ends.
  [[nodiscard]] TouchSample step(const Point<DepthCamera>& device, SessionTime now, double dt_s,
                                 bool felt = true) noexcept;

  /// Displacement at the foot after the last step; zero while no foot is known. Evaluates the surface twice.
  [[nodiscard]] Displaced displaced() const noexcept;

  [[nodiscard]] std::uint64_t out_of_order() const noexcept { return out_of_order_; }

 private:
  enum class Side { Unknown, Outside, Inside };

  [[nodiscard]] FieldSample field(const Eigen::Vector3d& at) const noexcept;
  [[nodiscard]] FieldSample field_at_foot() noexcept;
  [[nodiscard]] FieldSample meet(const Eigen::Vector3d& expected) noexcept;
  [[nodiscard]] FieldSample farthest_known(Eigen::Vector3d& goal) const noexcept;
  void carry_on(double dt_s, bool felt) noexcept;
  void look(const Eigen::Vector3d& device) noexcept;
  void reseed(const Eigen::Vector3d& device) noexcept;
  void follow(const Eigen::Vector3d& device) noexcept;
  void decide(const Eigen::Vector3d& device) noexcept;
  void show_at(const Eigen::Vector3d& device) noexcept;
  void look_at_anchor() noexcept;
  void follow_anchor(double dt_s) noexcept;
  void hold(double dt_s, const Eigen::Vector3d& device, bool felt) noexcept;
  void end_too_deep(const Eigen::Vector3d& device) noexcept;
  void leave(const Eigen::Vector3d& device, const Eigen::Vector3d& foot_before, double near_m, double dt_s) noexcept;
  [[nodiscard]] double height_of(const Eigen::Vector3d& device) const noexcept;
  [[nodiscard]] double sideways_of(const Eigen::Vector3d& device) const noexcept;
  [[nodiscard]] double age_s() const noexcept;
  [[nodiscard]] double freshness() const noexcept;
  [[nodiscard]] TouchSample answer(const Eigen::Vector3d& device) const noexcept;

  TouchSettings settings_;
  FollowLimits follow_;
  const SurfaceSnapshot* snapshot_ = nullptr;  // borrowed
  SessionTime snapshot_captured_{};            // a copy, because the snapshot may be freed before the next one comes
  SessionTime adopted_{};
  SurfaceFollower follower_{follow_};
  MotionBasis basis_;
  SessionTime now_{};
  Side side_ = Side::Unknown;
  bool has_foot_ = false;
  bool fresh_foot_ = false;     // the foot was found anew: the newest surface is displayed without a lag
  bool swapped_ = false;        // a new snapshot was adopted and has not been evaluated yet
  bool glides_ = false;         // the device left the body far from its foot; the displayed skin glides to it
  bool was_in_front_ = false;   // at the last step the device was outside, so a device now inside went through the skin
  FieldSample at_foot_;         // sample of the displayed surface at foot_
  double newest_velocity_ = 0;  // speed of the newest surface at foot_ [m/s]
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();  // the last valid normal
  Eigen::Vector3d device_ = Eigen::Vector3d::Zero();  // position of the device at the last step
  bool has_device_ = false;
  bool anchored_ = false;
  LineFollower anchor_{follow_};        // the displayed skin where the contact began
  bool anchor_seen_ = false;            // the newest surface is known at anchor_
  double anchor_lag_m_ = 0.0;           // from anchor_ to the newest surface, along the line
  double anchor_target_m_per_s_ = 0.0;  // speed of the newest surface at the anchor, along the line
  double anchor_looked_s_ = 0.0;        // time since the surface was evaluated at the anchor
  double anchor_speed_ = 0.0;           // mean speed of anchor_ along its line over the last step [m/s]
  double slide_ = 1.0;                  // share of the tangential step towards the device that the curvature allows
  double held_ = 0.0;  // factor on the contact, 0 to 1: the coverage, changed gradually; TouchSample::coverage
  std::uint64_t out_of_order_ = 0;
};

}  // namespace telepalp::surface
