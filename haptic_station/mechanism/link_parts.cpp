#include "haptic_station/mechanism/link_parts.h"

#include <array>
#include <cmath>

namespace telepalp::mechanism {
namespace {

using Eigen::Vector2d;

struct Line {
  Vector2d from_m;
  Vector2d along;  // unit
  double length_m;
};

Line line_of(const FourBar& bar, LinkPart part) noexcept {
  const Vector2d x = Vector2d::UnitX();
  const auto turned = [](double rad) -> Vector2d { return {std::cos(rad), std::sin(rad)}; };
  switch (part) {
    case LinkPart::Link1:
      return {Vector2d::Zero(), x, bar.l1_m};
    case LinkPart::Link2:
      return {Vector2d::Zero(), x, bar.l2_m};
    case LinkPart::Link3:
      return {Vector2d::Zero(), x, bar.l3_m};
    case LinkPart::Handle:
      return {bar.handle_at_m * x, turned(-bar.handle_rad), bar.handle_m};
    case LinkPart::Needle:
      return {bar.l2_m * x, turned(bar.needle_rad), bar.needle_m};
    default:
      return {Vector2d::Zero(), x, bar.l4_m};
  }
}

}  // namespace

std::string_view name(LinkPart part) noexcept {
  constexpr std::array<std::string_view, kLinkParts> kNames{"link1", "link2", "link3", "handle", "needle", "base"};
  return kNames[static_cast<std::size_t>(part)];
}

int body_of(LinkPart part) noexcept {
  constexpr std::array<int, kLinkParts> kBodies{1, 2, 3, 3, 2, 0};
  return kBodies[static_cast<std::size_t>(part)];
}

BodyPoint on_part(const FourBar& bar, LinkPart part, double share, double across_m) noexcept {
  const Line line = line_of(bar, part);
  const Vector2d left(-line.along.y(), line.along.x());
  return {body_of(part), line.from_m + share * line.length_m * line.along + across_m * left};
}

void set_lengths(PlanarMechanism& mechanism, const FourBar& bar) noexcept {
  mechanism.pins[1].one.at_m.x() = bar.l1_m;
  mechanism.pins[1].other.at_m.x() = bar.l2_m;
  mechanism.pins[2].other.at_m.x() = bar.l3_m;
  mechanism.pins[3].one.at_m.x() = bar.l4_m;
  mechanism.tip = on_part(bar, LinkPart::Needle, 1.0);
}

}  // namespace telepalp::mechanism
