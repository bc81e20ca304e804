#pragma once

#include <cstddef>
#include <optional>

#include "clients/report/compare/tick_comparison.h"

namespace telepalp::report {

/// A force that stays at one value while the other run's force is larger.
struct Clipped {
  bool in_b = false;  ///< false: in A
  double at_N = 0.0;
  double other_N = 0.0;  ///< the other run's largest force at these ticks
  std::size_t ticks = 0;
};

/// How two runs differ in contact with the skin. A figure is NaN (kUnknown) if there is too little contact for it.
struct ContactComparison {
  /// Force in B divided by force in A, at equal indentation in the same state: the median over states and indentations
  /// in steps of 1 mm. It does not depend on the skin's law, nor on where the devices are.
  double force_ratio = kUnknown;
  /// How much deeper a contact begins in B than in A, along the device's way in [mm]: the median over the pairs of
  /// contacts that begin within 0.4 s of each other.
  double deeper_mm = kUnknown;
  std::size_t pairs = 0;  ///< of contacts
  std::size_t contacts_a = 0, contacts_b = 0;
  std::optional<Clipped> clipped;
};

[[nodiscard]] ContactComparison compare_contacts(const Session& a, const Session& b);

}  // namespace telepalp::report
