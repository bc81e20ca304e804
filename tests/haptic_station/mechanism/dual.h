#pragma once

#include <cmath>

namespace telepalp::mechanism {

/// A number with its derivative by one variable: automatic differentiation, exact to rounding.
struct Dual {
  double value = 0.0;
  double slope = 0.0;
  Dual() = default;
  explicit Dual(double constant) : value(constant) {}
  Dual(double at, double derivative) : value(at), slope(derivative) {}

  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator-(Dual a) { return {-a.value, -a.slope}; }
  friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
  friend Dual operator/(Dual a, Dual b) {
    return {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)};
  }
  friend bool operator>(Dual a, Dual b) { return a.value > b.value; }
  friend Dual cos(Dual a) { return {std::cos(a.value), -std::sin(a.value) * a.slope}; }
  friend Dual sin(Dual a) { return {std::sin(a.value), std::cos(a.value) * a.slope}; }
  friend Dual sqrt(Dual a) { return {std::sqrt(a.value), a.slope / (2.0 * std::sqrt(a.value))}; }
};

}  // namespace telepalp::mechanism
