#pragma once

#include <array>

namespace telepalp {

/// The four uniform cubic B-splines that are nonzero between two knots: values, and derivatives by the position `t`
/// between these knots.
template <class Real>
struct CubicBSpline {
  std::array<Real, 4> weight{};  ///< sum to 1
  std::array<Real, 4> slope{};   ///< sum to 0
};

/// Evaluates the basis at the fraction `t`, 0 … 1, of the way from one knot to the next.
template <class Real>
[[nodiscard]] constexpr CubicBSpline<Real> cubic_b_spline(Real t) noexcept {
  const Real s = Real{1} - t;
  return {{s * s * s / Real{6}, (Real{4} - Real{6} * t * t + Real{3} * t * t * t) / Real{6},
           (Real{4} - Real{6} * s * s + Real{3} * s * s * s) / Real{6}, t * t * t / Real{6}},
          {Real{-0.5} * s * s, Real{1.5} * t * t - Real{2} * t, Real{2} * s - Real{1.5} * s * s, Real{0.5} * t * t}};
}

}  // namespace telepalp
