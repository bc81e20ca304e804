#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::surface {

/// The ways in which a snapshot's points may move after the instant they were seen: a linear part that dies away, and
/// two harmonics of breathing. A point's normal offset is the dot product of its coefficients with these.
inline constexpr int kMotionTerms = 5;
using MotionTerms = std::array<float, kMotionTerms>;

/// The terms' values [s, 1, 1, 1, 1] and rates [1, 1/s …] at one instant, the same for every point.
struct MotionBasis {
  MotionTerms value{};
  MotionTerms rate{};
};

/// How a snapshot is carried forward from its capture.
struct MotionModel {
  bool moves = false;  ///< false: a static model, or nothing known
  bool ages = true;    ///< false: a static model, which is never stale
  double breathing_rad_per_s = 0.0;
  double linear_fade_s = 0.3;   ///< a velocity is believed for about this long
  double freeze_from_s = 0.6;   ///< from this age on the model slows down, and stands still at twice this age
  double spread_m_per_s = 0.0;  ///< growth of the prediction's 1-sigma with age
};

/// Basis at `age_s` after the capture; all zero at age 0. Continuous with its rate in age.
[[nodiscard]] MotionBasis motion_basis(const MotionModel& model, double age_s) noexcept;

/// The implicit function and what belongs to it at one point.
struct FieldSample {
  bool valid = false;                                  ///< false: no surface here; all else is zero
  double f_m = 0.0;                                    ///< signed distance, to first order; negative in the body
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< of f, exact for the weights used
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< weighted mean of the points' normals, unit
  double support = 0.0;                                ///< 0 at the rim of what is known, 1 well inside; C1
  double velocity_m_per_s = 0.0;                       ///< of the surface along its normal, outwards positive
  double deviation_m = 0.0;                            ///< 1-sigma of f at the capture, by the points' statistics
};

/// Where a search for the foot may begin.
struct Seed {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  bool query_in_front = false;  ///< the query is on the outer side of the surface there
};

/// A surface at one capture instant, immutable, in the depth camera's frame. Built on the surface thread, read at 2
/// kHz: nothing here allocates, locks or throws, unless realtime_safe() says otherwise (the paper's reference does).
class SurfaceSnapshot {
 public:
  SessionTime captured{};
  std::uint64_t sequence = 0;
  std::uint32_t points = 0;         ///< in the index
  const char* index_name = "none";  ///< which neighbour index serves it
  MotionModel motion;

  /// The implicit function at `query`. `facing`: unit vector towards the side that is outside where two surfaces are
  /// near each other (the two sides of a sheet); zero when not known.
  [[nodiscard]] virtual FieldSample evaluate(const Eigen::Vector3d& query, const Eigen::Vector3d& facing,
                                             const MotionBasis& basis) const noexcept = 0;

  /// A point of the surface near `query`, from which to look for the foot; cheap and coarse. nullopt: none in reach.
  [[nodiscard]] virtual std::optional<Seed> seed(const Eigen::Vector3d& query) const noexcept = 0;

  /// How far the proxy may slide in one iteration [m]: within the support of evaluate().
  [[nodiscard]] virtual double stride_m(const Eigen::Vector3d& query) const noexcept = 0;

  /// Asks for what evaluate() near `query` will read, while nobody waits for it yet.
  virtual void prefetch(const Eigen::Vector3d& query) const noexcept { (void)query; }

  [[nodiscard]] virtual bool realtime_safe() const noexcept { return true; }

 protected:
  ~SurfaceSnapshot() = default;  // never destroyed through this type: shared_ptr keeps the maker's deleter
  SurfaceSnapshot() = default;
  SurfaceSnapshot(const SurfaceSnapshot&) = default;
  SurfaceSnapshot& operator=(const SurfaceSnapshot&) = default;
};

}  // namespace telepalp::surface
