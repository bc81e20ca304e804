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

Vector3d nearest_on(const Vector3d& from_m, const Vector3d& to_m, const Vector3d& at_m) noexcept {
  const Vector3d along = to_m - from_m;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(along.dot(at_m - from_m) / squared, 0.0, 1.0) : 0.0;
  return from_m + share * along;
}

}  // namespace

FeltLinkage::FeltLinkage(const HeldLinkage& at, const HeldMechanism& mechanism, solids::Rods rods,
                         const FeltSettings& settings) noexcept
    : bar_(at.bar()),
      wanted_(bar_),
      plane_(at.plane()),
      settings_(settings),
      mechanism_(mechanism),
      rods_(std::move(rods)) {
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
  const auto place = [this](LinkPart part, double share) -> InPlane<double> {
    const Vector2d at_m = place_of(on_part(bar_, part, share), mechanism_.pose());
    return {at_m.x(), at_m.y()};
  };
  const double axis_rad = mechanism_.pose()[5] + bar_.needle_rad;
  return {.b = place(LinkPart::Link2, 0.0),
          .p = place(LinkPart::Link1, 1.0),
          .d = place(LinkPart::Handle, 0.0),
          .c = place(LinkPart::Handle, 1.0),
          .tip = place(LinkPart::Needle, 1.0),
          .axis = {std::cos(axis_rad), std::sin(axis_rad)}};
}

double FeltLinkage::sine_of_links() const noexcept { return std::sin(mechanism_.pose()[5] - mechanism_.pose()[2]); }

std::array<FeltLinkage::Line, kLinkParts> FeltLinkage::lines() const noexcept {
  const FourBarPose<double> now = pose();
  const auto place = [this](const InPlane<double>& at) -> Vector3d { return in_space({at.x, at.y}).m; };
  const Vector3d a = plane_.pivot_a.m;
  const Vector3d o = place({bar_.l4_m, 0.0});
  return {Line{a, place(now.p)},        {place(now.b), place(now.p)},   {o, place(now.b)},
          {place(now.d), place(now.c)}, {place(now.p), place(now.tip)}, {a, o}};
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
  if (body_of(part) == 0) return;
  const Line line = lines()[static_cast<std::size_t>(part)];
  const Vector2d from_m = in_plane(line.from_m);
  const Vector2d along_m = in_plane(line.to_m) - from_m;
  const Vector2d to_m = in_plane(at_m) - from_m;
  const double length_m = along_m.norm();
  if (!(length_m > 0.0)) return;
  grasp_ = {.share = along_m.dot(to_m) / (length_m * length_m),
            .across_m = (along_m.x() * to_m.y() - along_m.y() * to_m.x()) / length_m};
  mechanism_.hold_at(on_part(bar_, part, grasp_.share, grasp_.across_m));
  off_plane_m_ = normal().dot(at_m - plane_.pivot_a.m);
  held_ = part;
  touched_.reset();
  proxy_m_ = at_m;
  still_to_come_m_ = in_plane(proxy_m_) - in_plane(hand_m_);
}

void FeltLinkage::approach_wanted(double dt_s) noexcept {
  if (bar_ == wanted_) return;
  FourBar next = bar_;
  approach(next, wanted_, settings_.slew, dt_s);
  PlanarMechanism changed = mechanism_.mechanism();
  set_lengths(changed, next);
  if (held_) changed.grasp = on_part(next, *held_, grasp_.share, grasp_.across_m);
  if (!mechanism_.change(changed)) return;
  bar_ = next;
  place_rods();
  if (!held_ && !inside_) touch_.start_at(proxy_m_);
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

void FeltLinkage::forget_hand() noexcept {
  let_go();
  touched_.reset();
  fading_N_.setZero();
  hand_m_ = proxy_m_;
  pressed_ = inside_ = true;
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
  approach_wanted(dt_s);
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
