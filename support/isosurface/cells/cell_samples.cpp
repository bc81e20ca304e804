#include "support/isosurface/cells/cell_samples.h"

namespace telepalp::isosurface {

const FieldAt& Sampler::at(const Eigen::Vector3i& node) {
  if (known_.size() >= kMost) known_ = {};
  const auto [found, added] = known_.insert(key_of(node));
  if (added) *found = gradients_ ? field_.at(lattice_.at(node)) : FieldAt{.m = field_.m_at(lattice_.at(node))};
  return *found;
}

CellSamples Sampler::of_cell(const Eigen::Vector3i& low, int side) {
  CellSamples samples{.low = lattice_.at(low), .side_m = lattice_.step_m * side};
  for (int i = 0; i < 27; ++i)
    samples.at[static_cast<std::size_t>(i)] = at(low + side / 2 * Eigen::Vector3i(i % 3, i / 3 % 3, i / 9));
  return samples;
}

}  // namespace telepalp::isosurface
