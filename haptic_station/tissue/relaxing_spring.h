#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace telepalp::tissue {

/// How a stretched tissue relaxes: a spring beside Maxwell branches (Mahvash and Dupont 2010, docs/sources.md, use
/// one branch). The shares of branches sum to at most 1; the rest is the spring that never relaxes.
struct Relaxation {
  static constexpr int kMost = 4;
  int branches = 0;
  std::array<double, kMost> share{};   ///< of the stiffness, 0 to 1
  std::array<double, kMost> time_s{};  ///< time constant of the branch
};

/// A spring at the tip with the branches of a Relaxation. It has no stiffness of its own: all values are extensions
/// [m].
class RelaxingSpring {
 public:
  /// The branches relax over one tick.
  void relax(const Relaxation& by, double dt_s) noexcept {
    for (int i = 0; i < by.branches; ++i) branch_m_[i] *= std::exp(-dt_s / by.time_s[i]);
  }
  void move(const Eigen::Vector3d& by_m) noexcept {
    whole_m_ += by_m;
    for (Eigen::Vector3d& branch_m : branch_m_) branch_m += by_m;
  }
  /// The anchors follow the tip, so that all extensions are `share` of what they were. Stores less energy if share < 1.
  void shorten(double share) noexcept {
    whole_m_ *= share;
    for (Eigen::Vector3d& branch_m : branch_m_) branch_m *= share;
  }
  /// As shorten(), but only for the part that is perpendicular to the unit vector `axis`.
  void shorten_across(const Eigen::Vector3d& axis, double share) noexcept {
    const auto shorten = [&](Eigen::Vector3d& all_m) { all_m -= (1.0 - share) * (all_m - all_m.dot(axis) * axis); };
    shorten(whole_m_);
    for (Eigen::Vector3d& branch_m : branch_m_) shorten(branch_m);
  }
  [[nodiscard]] const Eigen::Vector3d& whole_m() const noexcept { return whole_m_; }
  /// Force divided by stiffness [m], a vector towards the tip.
  [[nodiscard]] Eigen::Vector3d extension_m(const Relaxation& by) const noexcept {
    double left = 1.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < by.branches; ++i) {
      left -= by.share[i];
      sum += by.share[i] * branch_m_[i];
    }
    return sum + left * whole_m_;
  }
  /// Stored energy divided by stiffness [m^2].
  [[nodiscard]] double stored_m2(const Relaxation& by) const noexcept {
    double left = 1.0;
    double sum = 0.0;
    for (int i = 0; i < by.branches; ++i) {
      left -= by.share[i];
      sum += by.share[i] * branch_m_[i].squaredNorm();
    }
    return 0.5 * (sum + left * whole_m_.squaredNorm());
  }

 private:
  Eigen::Vector3d whole_m_ = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, Relaxation::kMost> branch_m_{
      {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
};

}  // namespace telepalp::tissue
