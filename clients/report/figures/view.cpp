#include "clients/report/figures/view.h"

#include <cmath>

#include "clients/report/summary/phases.h"
#include "proto/wire/vector_message.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

bool in_front_of_camera(const msg::Vec3& at) { return std::isfinite(at.z()) && at.z() > 0.0; }

/// True once the station knows the position of its hand in the camera's frame.
bool is_drawable(const msg::StationState& state) {
  return state.has_device_camera() && in_front_of_camera(state.device_camera());
}

const msg::StationState* state_at(const Session& session, std::int64_t at_ns) {
  const msg::StationState* best = nullptr;
  const auto distance = [&](const msg::StationState& state) {
    return std::abs(static_cast<std::int64_t>(state.stamp_ns()) - at_ns);
  };
  for (const msg::StationState& state : session.states)
    if (is_drawable(state) && (best == nullptr || distance(state) < distance(*best))) best = &state;
  return best;
}

/// The attitude of the hand; nullopt: the tracker measured none, or it is not a rotation.
std::optional<Eigen::Quaterniond> attitude_of(const msg::StationState& state) {
  const msg::Rotation& told = state.hand_attitude_camera();
  const Eigen::Quaterniond q(told.w(), told.x(), told.y(), told.z());
  if (!(std::abs(q.norm() - 1.0) < 0.01)) return std::nullopt;
  return q.normalized();
}

ar::Touch touch_of(const msg::StationState& state) {
  const Point<DepthCamera> device{wire::vector_of(state.device_camera())};
  // Outside the body there may be no proxy. Then hand and proxy are drawn at the device.
  const Point<DepthCamera> proxy =
      in_front_of_camera(state.proxy_camera()) ? Point<DepthCamera>{wire::vector_of(state.proxy_camera())} : device;
  const Point<DepthCamera> hand = in_front_of_camera(state.displayed_hand_camera())
                                      ? Point<DepthCamera>{wire::vector_of(state.displayed_hand_camera())}
                                      : proxy;
  return {hand,
          proxy,
          device,
          {wire::vector_of(state.force_camera_n())},
          state.indentation_m(),
          state.in_body(),
          attitude_of(state)};
}

std::vector<ar::PanelLine> figures_of(const Session& session, const msg::StationState& state) {
  const double since_start_s =
      static_cast<double>(static_cast<std::int64_t>(state.stamp_ns()) - session.first_ns.value_or(0)) * 1e-9;
  std::vector<ar::PanelLine> lines{{"state", std::string(words_for(state.phase()).words)},
                                   {"force", plot::number(wire::vector_of(state.force_n()).norm(), 2) + " N"},
                                   {"indentation", plot::number(1e3 * state.indentation_m(), 1) + " mm"}};
  if (state.surface_captured_ns() > 0)
    lines.push_back(
        {"surface age",
         plot::number(
             static_cast<double>(static_cast<std::int64_t>(state.stamp_ns() - state.surface_captured_ns())) * 1e-6, 0) +
             " ms"});
  lines.push_back({"time", plot::number(since_start_s, 2) + " s"});
  return lines;
}

}  // namespace

std::int64_t deepest_moment_ns(const Session& session) {
  const msg::StationState* deepest = nullptr;
  for (const msg::StationState& state : session.states)
    if (is_drawable(state) && (deepest == nullptr || !(state.indentation_m() < deepest->indentation_m())))
      deepest = &state;
  if (deepest != nullptr) return static_cast<std::int64_t>(deepest->stamp_ns());
  return session.first_ns.value_or(0) + (session.last_ns.value_or(0) - session.first_ns.value_or(0)) / 2;
}

ColorImage draw_view(const Session& session, const RgbdFrame& frame, std::int64_t at_ns) {
  const msg::StationState* state = state_at(session, at_ns);
  if (state == nullptr)
    return ar::draw({.frame = frame, .touch = std::nullopt, .figures = {{"no station in this session", ""}}});
  return ar::draw({.frame = frame, .touch = touch_of(*state), .figures = figures_of(session, *state)});
}

}  // namespace telepalp::report
