#pragma once

#include "haptic_station/tissue/fem/prism_model.h"

namespace telepalp::bench {

/// Compliances of a prism at rest under a load along x [m/N].
struct PrismCompliance {
  double top = 0.0;   ///< of the whole top
  double half = 0.0;  ///< of a spot of 8 mm in the middle of the right side
};

/// A prism of finite elements.
[[nodiscard]] PrismCompliance compliance_of(const std::shared_ptr<const tissue::ElasticBody>& body);

/// A net of springs in its place: one spring of 1 N/m along each edge of the tetrahedra of `grid`, which is linear.
[[nodiscard]] PrismCompliance compliance_of_springs(const tissue::PrismGrid& grid);

}  // namespace telepalp::bench
