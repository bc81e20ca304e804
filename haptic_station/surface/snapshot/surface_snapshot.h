#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "haptic_station/surface/snapshot/skin_mark.h"
#include "proto/words/time.h"

namespace telepalp::surface {

/// The terms of a point's motion after its capture. Three predictions share them. The station's own prediction, by
/// SharedMotion and BreathingModel, has the first five: a linear term whose velocity decays, and cosine and sine of two
/// breathing harmonics. The straight prediction, by StraightMotion, has the sixth, which is linear, too. The seventh is
/// the way back to the mean place of the last 2 s, by RecentMean. A point's displacement along its normal is the dot
/// product of its coefficients and the terms.
inline constexpr int kMotionTerms = 7;
inline constexpr std::size_t kStraightTerm = 5;  ///< index of the straight prediction's term
inline constexpr std::size_t kMeanTerm = 6;      ///< index of the way back to the mean place
using MotionTerms = std::array<float, kMotionTerms>;

/// The terms' values [s, 1, 1, 1, 1, s, 1] and time derivatives [1, 1/s, 1/s, 1/s, 1/s, 1, 1/s] at one age of the
/// snapshot, equal for all points.
struct MotionBasis {
  MotionTerms value{};
  MotionTerms rate{};
};

/// Ages of a prediction for which SharedMotion and PastPredictions learn the weight of a predicted motion. Between
/// these ages the weight is interpolated; below the first and above the last one it is constant.
inline constexpr std::array kForesightAges_s{0.065, 0.12, 0.215};
/// Weight of a predicted motion at each of kForesightAges_s: 1: fully applied, 0: ignored.
using ForesightShare = std::array<double, kForesightAges_s.size()>;
inline constexpr ForesightShare kFullForesight{1.0, 1.0, 1.0};
inline constexpr ForesightShare kNoForesight{0.0, 0.0, 0.0};

/// How a snapshot is predicted forward from its capture.
struct MotionModel {
  bool moves = false;  ///< false: a static model, or an unknown motion
  bool ages = true;    ///< false: a static model, which is never stale
  double breathing_rad_per_s = 0.0;
  ForesightShare speed = kFullForesight;         ///< weight of the linear term and of the first harmonic's sine
  ForesightShare acceleration = kFullForesight;  ///< weight of the first harmonic's cosine
  ForesightShare own = kFullForesight;           ///< weight of the station's own prediction; own + straight <= 1
  ForesightShare straight = kNoForesight;        ///< weight of the straight prediction
  ForesightShare to_mean = kNoForesight;         ///< share of the way back to the mean place
  double linear_fade_s = 0.3;                    ///< time constant with which the velocity of both linear terms decays
  double freeze_from_s = 0.6;   ///< from this age the predicted motion slows down; it stops at twice this age
  double spread_m_per_s = 0.0;  ///< growth of the prediction's standard deviation with age
  double unmodelled = 0.0;      ///< 1: motion much faster than usual, or a pushed camera; afterwards 0 in 1 s
};

/// Basis at `age_s` after the capture; all zero at age 0. Value and rate are continuous in age.
[[nodiscard]] MotionBasis motion_basis(const MotionModel& model, double age_s) noexcept;

/// The implicit function at one point, with its derivatives and quality.
struct FieldSample {
  bool valid = false;                                  ///< false: no surface near the query; all else is zero
  double f_m = 0.0;                                    ///< signed distance to first order; negative in the body
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< of f; PaperSurface: the normal replaces it
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< weighted mean of the points' normals, unit
  double coverage = 0.0;                               ///< 0 at the rim of the known surface, 1 well inside; C1
  double velocity_m_per_s = 0.0;  ///< speed of the surface along its normal, out of the body positive
  double deviation_m = 0.0;       ///< standard deviation of f_m at the capture, from the noise of the points
};

/// Start of a search for the foot, the surface point nearest to the query.
struct Seed {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  bool query_in_front = false;  ///< true: the query lies on the outer side of the surface
};

/// A surface at one capture instant, immutable, in the depth camera's frame [m]. The surface thread builds it; the
/// haptic thread reads it at 2 kHz. No method allocates, locks or throws, unless realtime_safe() is false, as for
/// PaperSurface.
class SurfaceSnapshot {
 public:
  SessionTime captured{};
  std::uint64_t sequence = 0;
  std::uint32_t points = 0;         ///< number of points; of a grid: nodes with a confidence above 0
  const char* index_name = "none";  ///< name of the neighbour index
  MotionModel motion;
  SkinMarks marks{};  ///< the marks followed on the skin, at the capture

  /// The implicit function at `query`. `facing`: unit vector to the outside; zero when unknown. It selects between two
  /// near surfaces, such as the two sides of a sheet. `basis`: motion_basis() of `motion` at the present age.
  [[nodiscard]] virtual FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                             const MotionBasis& basis) const noexcept = 0;

  /// A surface point near `query`, cheap and coarse, from which the search for the foot starts. nullopt: there is no
  /// surface near `query`.
  [[nodiscard]] virtual std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept = 0;

  /// The longest step of the proxy in one iteration [m]: after it, evaluate() still finds the surface.
  [[nodiscard]] virtual double stride_m(const Eigen::Vector3d& query) const noexcept = 0;

  /// Prefetches into the cache the memory that evaluate() near `query` reads.
  virtual void prefetch(const Eigen::Vector3d& query) const noexcept { (void)query; }

  [[nodiscard]] virtual bool realtime_safe() const noexcept { return true; }

 protected:
  ~SurfaceSnapshot() = default;  // protected: shared_ptr destroys the derived type with its own deleter
  SurfaceSnapshot() = default;
  SurfaceSnapshot(const SurfaceSnapshot&) = default;
  SurfaceSnapshot& operator=(const SurfaceSnapshot&) = default;
};

}  // namespace telepalp::surface
