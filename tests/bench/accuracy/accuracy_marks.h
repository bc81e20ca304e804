#pragma once

#include "tests/bench/accuracy/accuracy_page.h"

namespace telepalp::bench {

/// The radius of a mark's patch of skin (surface::MarkTracker): processor time, and the error of the mark's
/// displacement on the synthetic torso, as a Kinect at 0.8 m sees it.
[[nodiscard]] PageTable marks_table();

}  // namespace telepalp::bench
