#pragma once

#include <string>
#include <vector>

namespace telepalp::bench {

/// A solid in Polish notation whose surface is known from geometry, without telepalp.
struct KnownSolid {
  std::string name;
  std::string polish;
  std::size_t parts;  ///< of its surface
  long euler;         ///< of its surface: 2 for each ball, 0 for each ring, 2 less for each further hole
  double volume_m3;   ///< by a formula, or by Monte Carlo on the solid's inequalities, to 0.1 %
};

/// Twenty solids: thin plates and shells, near gaps, bore holes that meet, sharp rims, nested shells, joints.
[[nodiscard]] std::vector<KnownSolid> known_solids();

/// Solids that have no right mesh, because they touch themselves, have no end or are empty.
[[nodiscard]] std::vector<KnownSolid> solids_without_mesh();

}  // namespace telepalp::bench
