#pragma once

#include <string>

namespace telepalp::report {

/// What differs between two scene files, in words: "line 23: stiffness_N_per_m: 160 in A, stiffness_N_per_m: 176 in B",
/// or "B lacks A's lines 26 to 33, from effects { to }". At most three places are named. Comments, empty lines and
/// indentation are not compared. Empty: no difference.
[[nodiscard]] std::string scene_difference(const std::string& a, const std::string& b);

}  // namespace telepalp::report
