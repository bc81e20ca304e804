#include "haptic_station/mechanism/crank_range.h"

#include <algorithm>
#include <cmath>

namespace telepalp::mechanism {
namespace {
constexpr double kRounding = 1e-12;
}  // namespace

double CrankRange::nearest(double link3_rad) const noexcept {
  return whole_turn ? link3_rad : std::clamp(link3_rad, from_rad, to_rad);
}

CrankRange crank_range(const FourBar& bar, double near_rad) noexcept {
  const auto cosine_at = [&](double distance_m) {  // of link 3's angle while |AB| is `distance_m`
    return (distance_m * distance_m - bar.l3_m * bar.l3_m - bar.l4_m * bar.l4_m) / (2.0 * bar.l3_m * bar.l4_m);
  };
  const double stretched = cosine_at(bar.l1_m + bar.l2_m);
  const double folded = cosine_at(bar.l1_m - bar.l2_m);
  const bool through_zero = stretched >= 1.0 - kRounding;
  const bool through_half_turn = folded <= -1.0 + kRounding;
  if (through_zero && through_half_turn) return {.from_rad = 0.0, .to_rad = 0.0, .whole_turn = true};
  const double outer_rad = std::acos(std::clamp(stretched, -1.0, 1.0));
  const double inner_rad = std::acos(std::clamp(folded, -1.0, 1.0));
  const double near = std::remainder(near_rad, kTurn_rad);
  if (through_zero) return {near_rad - near - inner_rad, near_rad - near + inner_rad};
  if (through_half_turn) {
    const double turn_rad = near_rad - (near < 0.0 ? near + kTurn_rad : near);
    return {turn_rad + outer_rad, turn_rad + kTurn_rad - outer_rad};
  }
  const double turn_rad = near_rad - near;
  if (near >= 0.0) return {turn_rad + outer_rad, turn_rad + inner_rad};
  return {turn_rad - inner_rad, turn_rad - outer_rad};
}

}  // namespace telepalp::mechanism
