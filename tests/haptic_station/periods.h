#pragma once

namespace telepalp {

inline constexpr double kTick_s = 0.0005;       ///< of the haptic loop
inline constexpr double kFrame_s = 1.0 / 30.0;  ///< of a camera
inline constexpr int kTicksPerFrame = 67;

}  // namespace telepalp
