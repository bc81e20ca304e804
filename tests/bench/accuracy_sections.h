#pragma once

#include <vector>

#include "tests/bench/accuracy_page.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// What a part of the accuracy benchmark found: figures, and how the page tells of them.
struct Section {
  std::vector<Row> rows;
  std::vector<PagePart> parts;
  std::vector<PagePicture> pictures;
};

/// The surface's settings and parameters: error, cost, the front of both and its knee; then over noise and density.
[[nodiscard]] Result<Section> surface_section();
/// What each setting errs on patients who move.
[[nodiscard]] Result<Section> patients_section();
/// Models that predict the hand, and what carries the surface forward.
[[nodiscard]] Result<Section> prediction_section();
/// An organ's cells: what a coarser lattice saves, and how far the organ moves.
[[nodiscard]] Result<Section> organ_section();
/// The stiffest wall that the simulated device can show, over sampling rate and damping.
[[nodiscard]] Result<Section> z_width_section();
/// The depth codec's modes, and what Bounded's error costs the finger.
[[nodiscard]] Result<Section> depth_section();

}  // namespace telepalp::bench
