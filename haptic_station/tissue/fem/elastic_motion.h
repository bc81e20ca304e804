#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "haptic_station/tissue/fem/elastic_body.h"

namespace telepalp::tissue {

/// Nodes over which a load is spread. All shares sum to 1.
struct Patch {
  std::vector<std::pair<std::uint32_t, double>> shares;  ///< of free nodes, by their number among the free nodes
  Eigen::Vector3d fixed_m = Eigen::Vector3d::Zero();     ///< sum of share × place of the fixed nodes
};

/// The mean place of a patch [m].
[[nodiscard]] Eigen::Vector3d place_of(const Patch& patch, const NodeField& at);

/// A spring that pushes a patch inwards, without friction, while a tool's plane is deeper than the patch. Its force is
/// stiffness × depth, with depth = normal · patch - limit.
struct PatchContact {
  Patch patch;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< outwards
  double limit_m = 0.0;                               ///< normal · x of the tool
  double stiffness_N_per_m = 0.0;
  [[nodiscard]] double depth_m(const NodeField& at) const { return normal.dot(place_of(patch, at)) - limit_m; }
};

/// How a step of ElasticMotion ended.
struct StepOutcome {
  int rounds = 0;          ///< of Newton's method
  bool converged = false;  ///< the last round moved no node by more than the tolerance
  bool finite = true;      ///< false: a place or velocity is not a number, and the body was set back to rest
  bool clamped = false;    ///< negative curvature, if any, was replaced in a round
};

/// Newton's method stops here.
struct StepLimits {
  double moved_m = 1e-9;  ///< when no node moves by more in a round
  int most_rounds = 30;
};

/// An elastic body in motion, by the implicit Euler method as a minimisation: the new places minimise elastic energy +
/// contact energy + sum of m / 2 (1/h^2 + damping/h) |x - predicted|^2 (Martin and others 2011; Gast and others 2015).
/// Newton's method with line search lowers this sum in each round, so elastic and contact energy after a step are at
/// most the whole energy before it. Where the energy is not convex, the velocities are then scaled down, so that the
/// whole energy never rises. Steps may have any length. Owner: one thread.
class ElasticMotion {
 public:
  /// `damping_per_s`: deceleration of each node over its velocity.
  ElasticMotion(std::shared_ptr<const ElasticBody> body, double damping_per_s);

  void set_to_rest();
  /// Moves the nodes, for example into an inverted state, and stops them.
  void put(const NodeField& at);
  /// `contact`: as it is at the end of the step; nullptr: none.
  StepOutcome step(double dt_s, const PatchContact* contact, const StepLimits& limits = {});

  /// How far `patch` moves along `direction` for each newton along it, in the static limit and to first order, at the
  /// last state for which a step was computed [m/N].
  [[nodiscard]] double compliance_m_per_N(const Patch& patch, const Eigen::Vector3d& direction);

  [[nodiscard]] const ElasticBody& body() const noexcept { return *body_; }
  [[nodiscard]] const NodeField& at() const noexcept { return at_; }
  [[nodiscard]] double kinetic_J() const;
  [[nodiscard]] double elastic_J() const noexcept { return elastic_J_; }

 private:
  struct Round;
  bool factorise(Curvature curvature, NodeField* gradient_N);
  double search(Round& round);
  void descend(const Round& round, NodeField& moved) const;
  void keep_energy(const NodeField& before, double budget_J, double dt_s, const PatchContact* contact);

  std::shared_ptr<const ElasticBody> body_;
  double damping_per_s_;
  NodeField at_;
  double elastic_J_ = 0.0;
  NodeField velocity_;               ///< [m/s]
  StiffnessMatrix system_;           ///< second derivative of the sum that a step minimises, without the contact
  Eigen::VectorXd inertia_N_per_m_;  ///< the part of its diagonal that the masses add
  Eigen::SimplicialLLT<StiffnessMatrix, Eigen::Lower> factor_;
};

}  // namespace telepalp::tissue
