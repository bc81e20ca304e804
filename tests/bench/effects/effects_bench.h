#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Implicit solids and layers: cost of evaluation and proxy over the tree's size, gradient, ribs and masses found by a
/// scripted finger, the bill of an effect that a scene does not name, and the ultrasound image.
Result<Report> run_effects(const program::Arguments& arguments);

}  // namespace telepalp::bench
