#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "haptic_station/device/random.h"
#include "haptic_station/tissue/fem/prism_model.h"

namespace telepalp::tissue {

/// A body of rubber: 1 MPa, ν = 0.45.
inline std::shared_ptr<const ElasticBody> rubber(const PrismGrid& grid, double poisson = 0.45, double young_Pa = 1e6) {
  return std::make_shared<const ElasticBody>(*make_prism(grid), lame(young_Pa, poisson), 1000.0);
}

/// Lateral stiffness of the top of a prism of 20 × 20 × 100 mm with equal cells, per pascal of Young's modulus [m].
inline double stiffness_per_Pa(int across, int along, ElementOrder order, double poisson) {
  return top_stiffness_N_per_m(
      rubber({.across = across, .along = along, .grading = 1.0, .order = order}, poisson, 1.0));
}

/// Places near those at rest, each moved by up to `by_m` along each axis.
inline NodeField shaken(const ElasticBody& body, double by_m, std::uint64_t seed) {
  device::Random random(seed);
  NodeField at = body.rest();
  for (Eigen::Index i = 0; i < at.size(); ++i) at.data()[i] += random.uniform(-by_m, by_m);
  return at;
}

/// States of a prism of 0.1 m in which elements are flat or inverted, with their names.
inline std::vector<std::pair<const char*, NodeField>> inverted_states(const ElasticBody& body) {
  std::vector<std::pair<const char*, NodeField>> states;
  const auto add = [&](const char* name) -> NodeField& { return states.emplace_back(name, body.rest()).second; };
  NodeField& node = add("one node pushed through its neighbours");
  node.col(node.cols() / 2) += Eigen::Vector3d(0.025, -0.03, 0.02);
  add("pressed flat").row(1).setZero();
  add("shrunk to a point").setZero();
  NodeField& folded = add("its upper half folded down through the lower one");
  for (Eigen::Index i = 0; i < folded.cols(); ++i) folded(1, i) = std::min(folded(1, i), 0.09 - folded(1, i));
  add("turned inside out sideways").row(0) *= -1.0;
  return states;
}

/// The places of a prism that is mirrored at its floor.
inline NodeField mirrored(const ElasticBody& body) {
  NodeField at = body.rest();
  at.row(1) *= -1.0;
  return at;
}

/// Most that a node is away from its place at rest [m].
inline double away_m(const ElasticMotion& motion) {
  return (motion.at() - motion.body().rest()).colwise().norm().maxCoeff();
}

/// Steps of `dt_s` until the body is back, at most `seconds`.
inline void settle(ElasticMotion& motion, double seconds, double dt_s = 1.0 / 60.0) {
  for (double t = 0.0; t < seconds; t += dt_s) (void)motion.step(dt_s, nullptr);
}

}  // namespace telepalp::tissue
