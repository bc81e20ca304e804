#include "haptic_station/tissue/fem/elastic_motion.h"

#include <algorithm>
#include <cmath>

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

  struct Energy {
    double elastic_J = 0.0;
    double sum_J = 0.0;
  };
  [[nodiscard]] Energy of(double elastic_J, const NodeField& at) const {
    const NodeField away = at - predicted;
    return {elastic_J, elastic_J + kinetic_of(away, inertia_N_per_m) + contact_J(contact, at)};
  }
  [[nodiscard]] Energy energy(const NodeField& at) const { return of(body.energy_J(at), at); }
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
  body_->hessian(at_, curvature, system_, gradient_N);
  for (Index node = 0; node < inertia_N_per_m_.size(); ++node)
    for (Index i = 3 * node; i < 3 * node + 3; ++i) system_.coeffRef(i, i) += inertia_N_per_m_[node];
  factor_.factorize(system_);
  return factor_.info() == Eigen::Success;
}

/// Newton's step from the gradient without the contact. The contact adds one direction of stiffness k b b^T to the
/// factorised system (Sherman and Morrison), if the patch is deeper than the tool's plane after the step without it: a
/// body that springs back stops at the tool, and one that leaves it is not held back.
void ElasticMotion::descend(const Round& round, NodeField& moved) const {
  VectorXd way = factor_.solve(-as_vector(round.gradient_N));
  if (round.contact != nullptr) {
    const VectorXd b = load_of(round.contact->patch, round.contact->normal, way.size());
    if (const double depth_m = round.contact->depth_m(at_) + b.dot(way); depth_m > 0.0) {
      const VectorXd soft = factor_.solve(b);
      way -= soft * (depth_m / (1.0 / round.contact->stiffness_N_per_m + b.dot(soft)));
    }
  }
  moved = Eigen::Map<const NodeField>(way.data(), 3, way.size() / 3);
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
  StepOutcome outcome;
  while (outcome.rounds < limits.most_rounds && !outcome.converged && outcome.finite) {
    ++outcome.rounds;
    bool positive = factorise(Curvature::Exact, &round.gradient_N);
    if (!positive) {
      outcome.clamped = true;
      positive = factorise(Curvature::Positive, nullptr);
    }
    outcome.finite = positive && round.gradient_N.allFinite();
    if (outcome.finite) outcome.converged = search(round) <= limits.moved_m;
  }
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
/// by the inertia alone: a few rounds suffice for steps that are longer than the body's period. The error of the
/// compliance is the square of the tolerance: load . moved is the energy that the rounds minimise.
double ElasticMotion::compliance_m_per_N(const Patch& patch, const Vector3d& direction) {
  constexpr int kMostRounds = 60;
  constexpr double kTolerance = 1e-5;
  const VectorXd load = load_of(patch, direction, system_.rows());
  VectorXd inertia(system_.rows());
  for (Index node = 0; node < inertia_N_per_m_.size(); ++node)
    inertia.segment<3>(3 * node).setConstant(inertia_N_per_m_[node]);
  VectorXd moved = factor_.solve(load);
  VectorXd left = inertia.cwiseProduct(moved);  // load - stiffness × moved
  VectorXd towards = factor_.solve(left);
  VectorXd way = towards;
  double size = left.dot(towards);
  const double enough = kTolerance * kTolerance * load.dot(moved);
  for (int i = 0; i < kMostRounds && size > enough; ++i) {
    const VectorXd stiff = system_.selfadjointView<Eigen::Lower>() * way - inertia.cwiseProduct(way);
    const double bent = way.dot(stiff);
    if (!(bent > 0.0)) break;  // the body buckles in this direction
    moved += size / bent * way;
    left -= size / bent * stiff;
    towards = factor_.solve(left);
    const double before = size;
    size = left.dot(towards);
    way = towards + size / before * way;
  }
  return load.dot(moved);
}

}  // namespace telepalp::tissue
