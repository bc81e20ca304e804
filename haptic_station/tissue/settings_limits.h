#pragma once

namespace telepalp::tissue {

/// Allowed range of a setting, ends included.
struct Limit {
  double least;
  double most;
  const char* unit;
};

/// One limit for each number of TissueSettings, under its name.
namespace limits {

inline constexpr Limit kAt_m{-10, 10, "m"};
inline constexpr Limit kNetRadius_m{0.005, 0.2, "m"};
inline constexpr Limit kNetEdge_m{0.001, 0.05, "m"};
inline constexpr Limit kSpread_m{0.001, 0.05, "m"};
inline constexpr Limit kSubdivisions{0, 3, ""};
inline constexpr Limit kTop_m{0, 0.3, "m"};
inline constexpr Limit kThickness_m{0, 0.3, "m"};

// SurfaceSettings
inline constexpr Limit kStiffness_N_per_m{1, 20000, "N/m"};
inline constexpr Limit kStiffening_N_per_m2{0, 1e6, "N/m^2"};
inline constexpr Limit kPuncturesAt_N{0.01, 1e9, "N"};
inline constexpr Limit kFriction_N{0, 10, "N"};
inline constexpr Limit kBristle_N_per_m{10, 20000, "N/m"};
inline constexpr Limit kSideGrip{0, 3, "N/N"};
inline constexpr Limit kFallsIn_s{0.002, 0.5, "s"};

// BulkSettings
inline constexpr Limit kStick_N_per_m{10, 20000, "N/m"};
inline constexpr Limit kSlipsAt_N{0, 20, "N"};
inline constexpr Limit kSlipsAt_N_per_m{0, 500, "N/m"};
inline constexpr Limit kCutsAt_N{0, 20, "N"};
inline constexpr Limit kDamping_N_s_per_m{0, 100, "N s/m"};
inline constexpr Limit kResolution_m{1e-7, 0.01, "m"};
inline constexpr Limit kEqualReadings{1, 2000, ""};

// Relaxation
inline constexpr Limit kShare{0, 1, "N/N"};
inline constexpr Limit kTime_s{0.02, 1000, "s"};

// ShaftSettings
inline constexpr Limit kSide_N_per_m{0, 5000, "N/m"};
inline constexpr Limit kTearsAt_N_per_m{0, 1000, "N/m"};
inline constexpr Limit kBevel_rad{-1.0471975511965976, 1.0471975511965976, "rad"};  // 60 degrees

}  // namespace limits
}  // namespace telepalp::tissue
