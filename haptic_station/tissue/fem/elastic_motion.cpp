#include "haptic_station/tissue/fem/elastic_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace telepalp::tissue {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

Eigen::Map<const VectorXd> as_vector(const NodeField& field) { return {field.data(), field.size()}; }

/// Sum of m |v|^2 / 2.
double kinetic_of(const NodeField& velocity, const VectorXd& masses) {
  return 0.5 * velocity.colwise().squaredNorm().dot(masses.transpose());
}

double contact_J(const PatchContact* contact, const NodeField& at) {
  if (contact == nullptr) return 0.0;
  const double depth_m = std::max(0.0, contact->depth_m(at));
  return 0.5 * contact->stiffness_N_per_m * depth_m * depth_m;
}

/// The load of one newton along `direction`, spread over `patch`.
VectorXd load_of(const Patch& patch, const Vector3d& direction, Index size) {
  VectorXd load = VectorXd::Zero(size);
  for (const auto& [node, share] : patch.shares) load.segment<3>(3 * static_cast<Index>(node)) += share * direction;
  return load;
}

/// Sets `system` to the second derivative of the sum that a step minimises, without the contact; `inertia_N_per_m`: of
/// each node.
void assemble(const ElasticBody& body, const NodeField& at, const VectorXd& inertia_N_per_m, Curvature curvature,
              StiffnessMatrix& system, NodeField* gradient_N) {
  body.hessian(at, curvature, system, gradient_N);
  for (Index node = 0; node < inertia_N_per_m.size(); ++node)
    for (Index i = 3 * node; i < 3 * node + 3; ++i) system.coeffRef(i, i) += inertia_N_per_m[node];
}

using Factor = Eigen::SimplicialLLT<StiffnessMatrix, Eigen::Lower>;

/// A stiffness k b b^T that is added to a system.
struct AddedSpring {
  double N_per_m = 0.0;
  VectorXd direction;
  VectorXd soft;  ///< how far the direction's load moves the nodes in the factorised system [m/N]

  AddedSpring(double given_N_per_m, VectorXd along, const Factor& factor)
      : N_per_m(given_N_per_m), direction(std::move(along)), soft(factor.solve(direction)) {}
  [[nodiscard]] VectorXd times(const VectorXd& way) const { return N_per_m * direction.dot(way) * direction; }
  /// The motion under a load, from the motion without this spring (Sherman and Morrison).
  [[nodiscard]] VectorXd stiffened(const VectorXd& way) const {
    return way - soft * (direction.dot(way) / (1.0 / N_per_m + direction.dot(soft)));
  }
};

/// The motion under `load_N` by conjugate gradients, preconditioned by the factor of a system that is near: some
/// products cost less than a factorisation. nullopt: the energy curves downwards. `spring`: added to the system;
/// nullptr: none.
std::optional<VectorXd> moved_by(VectorXd load_N, const StiffnessMatrix& system, const Factor& near,
                                 const AddedSpring* spring) {
  constexpr int kMostProducts = 20;
  constexpr double kTolerance = 0.02;  // of the motion, in the norm of the energy
  const auto precondition = [&](const VectorXd& force_N) -> VectorXd {
    const VectorXd way = near.solve(force_N);
    return spring != nullptr ? spring->stiffened(way) : way;
  };
  VectorXd towards = precondition(load_N);
  VectorXd way = towards;
  VectorXd moved = VectorXd::Zero(load_N.size());
  double size = load_N.dot(towards);
  const double enough = kTolerance * kTolerance * size;
  for (int i = 0; i < kMostProducts && size > enough; ++i) {
    VectorXd bent_N = system.selfadjointView<Eigen::Lower>() * way;
    if (spring != nullptr) bent_N += spring->times(way);
    const double curved = way.dot(bent_N);
    if (!(curved > 0.0)) return std::nullopt;
    moved += size / curved * way;
    load_N -= size / curved * bent_N;
    towards = precondition(load_N);
    const double before = std::exchange(size, load_N.dot(towards));
    way = towards + size / before * way;
  }
  return moved;
}

}  // namespace

Vector3d place_of(const Patch& patch, const NodeField& at) {
  Vector3d sum = patch.fixed_m;
  for (const auto& [node, share] : patch.shares) sum += share * at.col(static_cast<Index>(node));
  return sum;
}

/// The sum that one step minimises.
struct ElasticMotion::Round {
  const ElasticBody& body;
  NodeField predicted;
  VectorXd inertia_N_per_m;  ///< of each node
  const PatchContact* contact;
  NodeField gradient_N{};  ///< of the elastic energy; then also of the terms that were added
  bool factorised = true;  ///< the system of this round; else the factor is that of the round before
  bool clamped = false;    ///< negative curvature, if any, was replaced in the system
  VectorXd load{};         ///< on the nodes, for one newton of the contact

  struct Energy {
    double elastic_J = 0.0;
    double sum_J = 0.0;
  };
  [[nodiscard]] Energy of(double elastic_J, const NodeField& at) const {
    const NodeField away = at - predicted;
    return {elastic_J, elastic_J + kinetic_of(away, inertia_N_per_m) + contact_J(contact, at)};
  }
  [[nodiscard]] Energy energy(const NodeField& at) const { return of(body.energy_J(at), at); }
  [[nodiscard]] double depth_m(const NodeField& at) const { return contact != nullptr ? contact->depth_m(at) : 0.0; }
  void add_inertia(const NodeField& at) { gradient_N += (at - predicted) * inertia_N_per_m.asDiagonal(); }
  void add_contact(const NodeField& at) {
    if (contact == nullptr) return;
    const double force_N = contact->stiffness_N_per_m * std::max(0.0, contact->depth_m(at));
    for (const auto& [node, share] : contact->patch.shares)
      gradient_N.col(static_cast<Index>(node)) += share * force_N * contact->normal;
  }
};

ElasticMotion::ElasticMotion(std::shared_ptr<const ElasticBody> body, double damping_per_s)
    : body_(std::move(body)), damping_per_s_(damping_per_s), system_(body_->pattern()) {
  factor_.analyzePattern(system_);
  set_to_rest();
}

void ElasticMotion::set_to_rest() {
  put(body_->rest());
  inertia_N_per_m_ = VectorXd::Zero(static_cast<Index>(body_->free_nodes()));
  factorise(Curvature::Positive, nullptr);
}

void ElasticMotion::put(const NodeField& at) {
  at_ = at;
  elastic_J_ = body_->energy_J(at);
  velocity_ = NodeField::Zero(3, at.cols());
}

double ElasticMotion::kinetic_J() const { return kinetic_of(velocity_, body_->masses()); }

/// True if the system is positive definite.
bool ElasticMotion::factorise(Curvature curvature, NodeField* gradient_N) {
  assemble(*body_, at_, inertia_N_per_m_, curvature, system_, gradient_N);
  factor_.factorize(system_);
  return factor_.info() == Eigen::Success;
}

/// Newton's step from the gradient without the contact. The contact adds one direction of stiffness k b b^T to the
/// system, if the patch is deeper than the tool's plane after the step: a body that springs back stops at the tool, and
/// one that leaves it is not held back. `moved` stays empty where the energy curves downwards.
void ElasticMotion::descend(const Round& round, NodeField& moved) const {
  const VectorXd load_N = -as_vector(round.gradient_N);
  const double depth_m = round.depth_m(at_);
  const auto is_closed_after = [&](const VectorXd& way) { return depth_m + round.load.dot(way) > 0.0; };
  const auto solved = [&](const VectorXd& force_N, const AddedSpring* spring) -> std::optional<VectorXd> {
    if (!round.factorised) return moved_by(force_N, system_, factor_, spring);
    const VectorXd way = factor_.solve(force_N);
    return spring != nullptr ? spring->stiffened(way) : way;
  };
  std::optional<VectorXd> way;
  if (round.contact != nullptr) {
    const AddedSpring spring(round.contact->stiffness_N_per_m, round.load, factor_);
    way = solved(load_N - spring.N_per_m * depth_m * spring.direction, &spring);
    if (!way) return;
  }
  if (round.contact == nullptr || !is_closed_after(*way)) way = solved(load_N, nullptr);
  if (way) moved = Eigen::Map<const NodeField>(way->data(), 3, way->size() / 3);
}

StepOutcome ElasticMotion::step(double dt_s, const PatchContact* contact, const StepLimits& limits) {
  const NodeField before = at_;
  const double budget_J = elastic_J_ + kinetic_J() + contact_J(contact, before);
  inertia_N_per_m_ = body_->masses() * (1.0 / dt_s + damping_per_s_) / dt_s;
  Round round{.body = *body_,
              .predicted = before + velocity_ * (dt_s / (1.0 + damping_per_s_ * dt_s)),
              .inertia_N_per_m = inertia_N_per_m_,
              .contact = contact};
  // Newton's method looks for the shape of the least energy. It begins at the shape to which the body would move by its
  // inertia alone, if the energy is lower there than at the present shape. Under a tool that moves steadily this saves
  // one of three rounds.
  if (const Round::Energy there = round.energy(round.predicted); there.sum_J < round.of(elastic_J_, at_).sum_J) {
    at_ = round.predicted;
    elastic_J_ = there.elastic_J;
  }
  if (contact != nullptr) round.load = load_of(contact->patch, contact->normal, system_.rows());
  StepOutcome outcome;
  while (outcome.rounds < limits.most_rounds && !outcome.converged && outcome.finite) {
    ++outcome.rounds;
    bool positive = true;
    round.factorised = outcome.rounds % 2 == 1;
    round.clamped = false;
    if (!round.factorised) {
      assemble(*body_, at_, inertia_N_per_m_, Curvature::Exact, system_, &round.gradient_N);
    } else if (outcome.rounds == 1 || !factorise(Curvature::Exact, &round.gradient_N)) {
      // The first round is far from the end, so the clamped system serves as well. The exact one is often not positive
      // there, and would cost a second factorisation.
      positive = factorise(Curvature::Positive, &round.gradient_N);
      round.clamped = true;
    }
    outcome.finite = positive && round.gradient_N.allFinite();
    if (outcome.finite) outcome.converged = search(round) <= limits.moved_m;
    outcome.clamped = outcome.clamped || round.clamped;
  }
  if (round.clamped) assemble(*body_, at_, inertia_N_per_m_, Curvature::Exact, system_, nullptr);  // for the compliance
  outcome.finite = outcome.finite && at_.allFinite() && std::isfinite(elastic_J_);
  if (outcome.finite)
    keep_energy(before, budget_J, dt_s, contact);
  else
    set_to_rest();
  return outcome;
}

/// One round of Newton's method. Returns how far it moved the nodes.
double ElasticMotion::search(Round& round) {
  constexpr double kArmijo = 1e-4;
  constexpr int kMostHalvings = 30;
  round.add_inertia(at_);
  NodeField moved;
  descend(round, moved);
  if (moved.size() == 0) {
    // As in a compressed or inverted element, which the steps of conjugate gradients would leave where it is.
    if (!factorise(Curvature::Positive, nullptr)) return 0.0;
    round.factorised = round.clamped = true;
    descend(round, moved);
  }
  round.add_contact(at_);
  const double begun_J = round.of(elastic_J_, at_).sum_J;
  const double slope_J = moved.cwiseProduct(round.gradient_N).sum();
  double length = 1.0;
  Round::Energy tried = round.energy(at_ + moved);
  for (int i = 0; i < kMostHalvings && !(tried.sum_J <= begun_J + kArmijo * length * slope_J); ++i) {
    length *= 0.5;
    tried = round.energy(at_ + length * moved);
  }
  if (!(tried.sum_J <= begun_J)) return 0.0;  // rounding hides what is left to gain
  at_ += length * moved;
  elastic_J_ = tried.elastic_J;
  return length * moved.cwiseAbs().maxCoeff();
}

void ElasticMotion::keep_energy(const NodeField& before, double budget_J, double dt_s, const PatchContact* contact) {
  velocity_ = (at_ - before) / dt_s;
  const double left_J = std::max(0.0, budget_J - elastic_J_ - contact_J(contact, at_));
  const double kinetic = kinetic_J();
  if (kinetic > left_J) velocity_ *= std::sqrt(left_J / kinetic);
}

/// Conjugate gradients on the stiffness without inertia, preconditioned by the factorised system, which differs from it
/// by the inertia and by what the last rounds changed: a few products suffice for steps that are longer than the body's
/// period. The error of the compliance is the square of the tolerance: load . moved is the energy that they minimise.
double ElasticMotion::compliance_m_per_N(const Patch& patch, const Vector3d& direction) {
  constexpr int kMostProducts = 60;
  constexpr double kTolerance = 3e-3;
  const VectorXd load = load_of(patch, direction, system_.rows());
  VectorXd inertia(system_.rows());
  for (Index node = 0; node < inertia_N_per_m_.size(); ++node)
    inertia.segment<3>(3 * node).setConstant(inertia_N_per_m_[node]);
  const auto stiffness_times = [&](const VectorXd& way) -> VectorXd {
    return system_.selfadjointView<Eigen::Lower>() * way - inertia.cwiseProduct(way);
  };
  VectorXd moved = factor_.solve(load);
  VectorXd left = load - stiffness_times(moved);
  VectorXd towards = factor_.solve(left);
  VectorXd way = towards;
  double size = left.dot(towards);
  const double enough = kTolerance * kTolerance * load.dot(moved);
  for (int i = 0; i < kMostProducts && size > enough; ++i) {
    const VectorXd stiff = stiffness_times(way);
    const double bent = way.dot(stiff);
    if (!(bent > 0.0)) break;  // the body buckles in this direction
    moved += size / bent * way;
    left -= size / bent * stiff;
    towards = factor_.solve(left);
    const double before = std::exchange(size, left.dot(towards));
    way = towards + size / before * way;
  }
  return load.dot(moved);
}

}  // namespace telepalp::tissue
