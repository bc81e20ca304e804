#include "haptic_station/mechanism/felt_linkage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptic_station/mechanism/constraint_rows.h"

namespace telepalp::mechanism {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kInside_m = 1e-4;  // a held point may lie this deep in a part, by rounding or at a joint
constexpr std::string_view kNames[kLinkParts] = {"link1", "link2", "link3", "handle", "needle", "base"};

/// The body of four_bar_design() of which a part is a piece; 0: the frame.
constexpr int body_of(LinkPart part) noexcept {
  constexpr int kBodies[kLinkParts] = {1, 2, 3, 3, 2, 0};
  return kBodies[static_cast<std::size_t>(part)];
}

Vector3d nearest_on(const Vector3d& from_m, const Vector3d& to_m, const Vector3d& at_m) noexcept {
  const Vector3d along = to_m - from_m;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(along.dot(at_m - from_m) / squared, 0.0, 1.0) : 0.0;
  return from_m + share * along;
}

}  // namespace

std::string_view name(LinkPart part) noexcept { return kNames[static_cast<std::size_t>(part)]; }

FeltLinkage::FeltLinkage(const HeldLinkage& at, const HeldMechanism& mechanism, solids::Rods rods,
                         const FeltSettings& settings) noexcept
    : bar_(at.bar()), plane_(at.plane()), settings_(settings), mechanism_(mechanism), rods_(std::move(rods)) {
  place_rods();
  hand_m_ = proxy_m_ = at.grasp().m;
}

Vector2d FeltLinkage::in_plane(const Vector3d& at_m) const noexcept {
  const Vector3d from_a = at_m - plane_.pivot_a.m;
  return {plane_.x.v.dot(from_a), plane_.y.v.dot(from_a)};
}

Point<HapticBase> FeltLinkage::in_space(const Vector2d& at_m, double off_plane_m) const noexcept {
  return {plane_.pivot_a.m + at_m.x() * plane_.x.v + at_m.y() * plane_.y.v + off_plane_m * normal()};
}

FourBarPose<double> FeltLinkage::pose() const noexcept {
  const auto place = [this](int body, double x_m, double y_m = 0.0) -> InPlane<double> {
    const Vector2d at_m = place_of({body, {x_m, y_m}}, mechanism_.pose());
    return {at_m.x(), at_m.y()};
  };
  const double handle_rad = -bar_.handle_rad;
  const double axis_rad = mechanism_.pose()[5] + bar_.needle_rad;
  const Vector2d tip_m = mechanism_.tip_m();
  return {.b = place(2, 0.0),
          .p = place(1, bar_.l1_m),
          .d = place(3, bar_.handle_at_m),
          .c = place(3, bar_.handle_at_m + bar_.handle_m * std::cos(handle_rad), bar_.handle_m * std::sin(handle_rad)),
          .tip = {tip_m.x(), tip_m.y()},
          .axis = {std::cos(axis_rad), std::sin(axis_rad)}};
}

double FeltLinkage::sine_of_links() const noexcept {
  return std::sin(mechanism_.pose()[5] - mechanism_.pose()[2]);
}

std::array<FeltLinkage::Line, kLinkParts> FeltLinkage::lines() const noexcept {
  const FourBarPose<double> now = pose();
  const auto place = [this](const InPlane<double>& at) -> Vector3d { return in_space({at.x, at.y}).m; };
  const Vector3d a = plane_.pivot_a.m;
  const Vector3d o = place({bar_.l4_m, 0.0});
  return {Line{a, place(now.p)},           {place(now.b), place(now.p)},   {o, place(now.b)},
          {place(now.d), place(now.c)},    {place(now.p), place(now.tip)}, {a, o}};
}

double FeltLinkage::radius_m(LinkPart part) const noexcept {
  return settings_.hand_radius_m + (part == LinkPart::Needle ? settings_.needle_radius_m : settings_.link_radius_m);
}

void FeltLinkage::place_rods() noexcept {
  const auto all = lines();
  for (std::size_t i = 0; i < kLinkParts; ++i)
    rods_.place(i, {all[i].from_m, all[i].to_m, radius_m(static_cast<LinkPart>(i))});
}

/// The part whose surface is nearest to `at_m`. Of parts that are equally near, as at a joint, the first one, so that
/// the fixed base comes last.
LinkPart FeltLinkage::part_at(const Vector3d& at_m) const noexcept {
  constexpr double kAsNear_m = 1e-5;
  const auto all = lines();
  double least_m = std::numeric_limits<double>::infinity();
  auto nearest = LinkPart::Base;
  for (std::size_t i = 0; i < kLinkParts; ++i) {
    const auto part = static_cast<LinkPart>(i);
    const double m = (nearest_on(all[i].from_m, all[i].to_m, at_m) - at_m).norm() - radius_m(part);
    if (m > least_m - kAsNear_m) continue;
    least_m = m;
    nearest = part;
  }
  return nearest;
}

void FeltLinkage::attach(LinkPart part, const Vector3d& at_m) noexcept {
  const int body = body_of(part);
  if (body == 0) return;
  const auto first = 3 * (body - 1);
  const Vector2d from_m = in_plane(at_m) - mechanism_.pose().segment<2>(first);
  const double turned = mechanism_.pose()[first + 2];
  const Vector2d x(std::cos(turned), std::sin(turned));
  mechanism_.hold_at({body, {x.dot(from_m), x.x() * from_m.y() - x.y() * from_m.x()}});
  off_plane_m_ = normal().dot(at_m - plane_.pivot_a.m);
  held_ = part;
  touched_.reset();
  proxy_m_ = at_m;
  still_to_come_m_ = in_plane(proxy_m_) - in_plane(hand_m_);
}

void FeltLinkage::hold(LinkPart part, const Point<HapticBase>& at) noexcept {
  let_go();
  if (!at.m.allFinite()) return;
  const Line line = lines()[static_cast<std::size_t>(part)];
  hand_m_ = proxy_m_ = nearest_on(line.from_m, line.to_m, at.m);
  attach(part, proxy_m_);
}

void FeltLinkage::let_go() noexcept {
  if (!held_) return;
  held_.reset();
  place_rods();
  touch_.start_at(proxy_m_);
  inside_ = solids::solid_at(rods_.tree(), proxy_m_).m < -kInside_m;
}

/// The proxy of a hand that holds nothing, and the part that it touches.
void FeltLinkage::touch() noexcept {
  if (inside_ && solids::solid_at(rods_.tree(), hand_m_).m > 0.0) {
    inside_ = false;
    touch_.start_at(hand_m_);
  }
  const solids::ProxyAt at = inside_ ? solids::ProxyAt{.at = hand_m_} : touch_.step(rods_.tree(), hand_m_);
  proxy_m_ = at.at;
  touched_ = at.depth_m > 0.0 ? std::optional(part_at(proxy_m_)) : std::nullopt;
}

void FeltLinkage::step(const Point<HapticBase>& hand, bool pressed, double dt_s) noexcept {
  const bool pressed_now = !std::exchange(pressed_, pressed) && pressed;
  if (!hand.m.allFinite()) {
    hand_m_ = proxy_m_;
    fading_N_.setZero();
    return;
  }
  hand_m_ = hand.m;
  fading_N_ *= std::exp(-dt_s / kFades_s);
  if (held_ && pressed) {
    still_to_come_m_ *= std::exp(-dt_s / kComes_s);
    mechanism_.step(in_plane(hand_m_) + still_to_come_m_);
    proxy_m_ = in_space(mechanism_.grasp_m(), off_plane_m_).m;
    return;
  }
  const Vector3d grasp_N = spring_N();  // where the hand now is
  const bool lets_go = held_.has_value();
  let_go();
  touch();
  if (lets_go) fading_N_ += grasp_N - spring_N();
  if (pressed_now && touched_) attach(*touched_, proxy_m_);
}

Force<HapticBase> FeltLinkage::hand_force(const Force<HapticBase>& at_tip) const noexcept {
  if (!held_) return {};
  const Vector2d N = mechanism_.hand_force_N({plane_.x.v.dot(at_tip.N), plane_.y.v.dot(at_tip.N)});
  return {N.x() * plane_.x.v + N.y() * plane_.y.v};
}

Vector<HapticBase> FeltLinkage::needle_axis() const noexcept {
  const double axis_rad = mechanism_.pose()[5] + bar_.needle_rad;
  return {std::cos(axis_rad) * plane_.x.v + std::sin(axis_rad) * plane_.y.v};
}

}  // namespace telepalp::mechanism
