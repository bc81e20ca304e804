#include "haptic_station/tissue/fem/prism_touch.h"

#include <algorithm>
#include <utility>

namespace telepalp::tissue {

using Eigen::Vector3d;

namespace {

constexpr double kNear_m = 0.03;  // a tool farther away has no plane

/// True unless the tool is beside the side, beyond one of its edges.
bool faces(const SidePoint& spot, const Vector3d& tool_m) {
  constexpr double kBeyond_m = 0.002;
  return (spot.at_m - tool_m - spot.behind_m * spot.normal).norm() <= kBeyond_m;
}

}  // namespace

PrismTouch::PrismTouch(std::shared_ptr<const PrismModel> model)
    : model_(std::move(model)), motion_(model_->body, model_->settings.damping_per_s), surface_(motion_.body()) {}

void PrismTouch::disturb(const NodeField& at) {
  motion_.put(at);
  at_rest_ = false;
}

/// The next state, and the side that is pressed or nearest.
void PrismTouch::judge(const SidePoints& sides, const Vector3d& tool_m) {
  const bool inside = is_inside(sides, tool_m);
  if (contact_ == PrismContact::Passed && !inside) contact_ = PrismContact::Free;
  if (contact_ == PrismContact::Pressed) {
    if (!inside && !faces(sides[static_cast<std::size_t>(*side_)], tool_m)) contact_ = PrismContact::Free;
  } else if (contact_ == PrismContact::Free && inside) {
    contact_ = side_ ? PrismContact::Pressed : PrismContact::Passed;
  }
  if (contact_ != PrismContact::Free) return;
  const auto nearest = std::ranges::min_element(sides, {}, &SidePoint::away_m);
  side_ = static_cast<PrismSide>(nearest - sides.begin());
}

/// One step of the body. False: it diverged.
bool PrismTouch::move(double dt_s, const PatchContact* contact) {
  constexpr StepLimits kLive{.moved_m = 1e-6, .most_rounds = 2};
  constexpr double kRest_m = 1e-9;
  outcome_ = {};
  if (contact == nullptr && at_rest_) return true;
  const NodeField before = motion_.at();
  outcome_ = motion_.step(dt_s, contact, kLive);
  if (!outcome_.finite) {
    at_rest_ = true;
    return false;
  }
  const bool free = contact == nullptr || contact->depth_m(motion_.at()) <= 0.0;
  // A free body that stands still is at rest, or in a false minimum of the energy of inverted elements. Both end at
  // rest.
  at_rest_ = free && (motion_.at() - before).cwiseAbs().maxCoeff() < kRest_m;
  if (at_rest_) motion_.set_to_rest();
  return true;
}

/// True if the tool must be an obstacle in the next step: it presses the prism, or a prism in motion may reach it.
bool PrismTouch::meets(const SidePoints& sides, const Vector3d& tool_m) const {
  if (contact_ != PrismContact::Free || at_rest_) return contact_ == PrismContact::Pressed;
  const SidePoint& spot = sides[static_cast<std::size_t>(*side_)];
  return spot.away_m <= kNear_m && faces(spot, tool_m);
}

double PrismTouch::felt_N_per_m(double compliance_m_per_N) const noexcept {
  const double coupling = model_->settings.coupling_N_per_m;
  return 1.0 / (compliance_m_per_N + (coupling > 0.0 ? 1.0 / coupling : 0.0));
}

/// A step with the tool as an obstacle. Without a force after it, the tool is free.
LocalPlane PrismTouch::pushed(const SidePoint& spot, const Vector3d& tool_m, double dt_s) {
  const PrismSettings& settings = model_->settings;
  PatchContact contact{.patch = patch_around(motion_.body().mesh(), *side_, spot.rest_m, settings.spread_m),
                       .normal = surface_.normal_around(*side_, spot.rest_m, settings.spread_m, motion_.at()),
                       .stiffness_N_per_m = felt_N_per_m(1.0 / (kPressed * settings.top_N_per_m))};
  contact.limit_m = contact.normal.dot(tool_m);
  if (!move(dt_s, &contact)) return {};
  pressed_N_ = contact.stiffness_N_per_m * std::max(0.0, contact.depth_m(motion_.at()));
  contact_ = pressed_N_ > model_->settings.lets_go_N ? PrismContact::Passed
             : pressed_N_ > 0.0                      ? PrismContact::Pressed
                                                     : PrismContact::Free;
  if (contact_ != PrismContact::Pressed) return {};
  const double compliance = motion_.compliance_m_per_N(contact.patch, contact.normal);
  const Vector3d at_m = place_of(contact.patch, motion_.at());
  return {.normal = contact.normal,
          .offset_m = contact.normal.dot(at_m) + pressed_N_ * compliance,
          .stiffness_N_per_m = felt_N_per_m(compliance),
          .at_m = at_m,
          .in_contact = true};
}

/// The plane through the nearest point of the prism, perpendicular to the line from there to the tool: the smallest
/// motion to the prism is along this line. If the prism has moved over the tool, the plane is the side's own.
LocalPlane PrismTouch::near(const SidePoints& sides, const Vector3d& tool_m) {
  constexpr double kTouching_m = 1e-5;
  const SidePoint& spot = sides[static_cast<std::size_t>(*side_)];
  if (spot.away_m > kNear_m) return {};
  const double spread_m = model_->settings.spread_m;
  const Vector3d normal = spot.away_m > kTouching_m && !is_inside(sides, tool_m)
                              ? Vector3d((tool_m - spot.at_m) / spot.away_m)
                              : surface_.normal_around(*side_, spot.rest_m, spread_m, motion_.at());
  const Patch patch = patch_around(motion_.body().mesh(), *side_, spot.rest_m, spread_m);
  return {.normal = normal,
          .offset_m = normal.dot(spot.at_m),
          .stiffness_N_per_m = felt_N_per_m(motion_.compliance_m_per_N(patch, normal)),
          .at_m = spot.at_m};
}

std::optional<LocalPlane> PrismTouch::step(const Vector3d& tool_m, double dt_s) {
  if (!tool_m.allFinite()) return std::nullopt;
  const Vector3d own_m = tool_m - model_->settings.foot_m;  // in the prism's own axes
  const SidePoints sides = surface_.nearest(own_m, motion_.at());
  judge(sides, own_m);
  pressed_N_ = 0.0;
  LocalPlane plane;
  if (meets(sides, own_m))
    plane = pushed(sides[static_cast<std::size_t>(*side_)], own_m, dt_s);
  else
    move(dt_s, nullptr);
  if (outcome_.finite && contact_ == PrismContact::Free) plane = near(surface_.nearest(own_m, motion_.at()), own_m);
  if (!outcome_.finite) {
    contact_ = PrismContact::Passed;
    return std::nullopt;
  }
  if (contact_ == PrismContact::Passed) return LocalPlane{};
  plane.offset_m += plane.normal.dot(model_->settings.foot_m);
  plane.at_m += model_->settings.foot_m;
  return plane;
}

}  // namespace telepalp::tissue
