#pragma once

namespace telepalp {

/// The scale of every drawing of a touch: the page, `view.png` and Foxglove's scene show the same. A test compares the
/// viewer's constants (clients/viewer/src/scene/drawn_sizes.ts) with these.
inline constexpr double kArrow_m_per_N = 0.02;  ///< length of the arrow of a force
inline constexpr double kBallRadius_m = 0.03;   ///< of the end-effector: a ball of 6 cm (S1 II.A)

}  // namespace telepalp
