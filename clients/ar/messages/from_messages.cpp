#include "clients/ar/messages/from_messages.h"

#include <cmath>

#include "clients/ar/messages/phases.h"
#include "proto/wire/station/contact_force.h"
#include "proto/wire/vector_message.h"
#include "proto/words/numbers/fixed_text.h"

namespace telepalp::ar {
namespace {

bool in_front_of_camera(const msg::Vec3& at) { return std::isfinite(at.z()) && at.z() > 0.0; }

/// The attitude of the hand; nullopt: the tracker measured no attitude, or the message's numbers are no rotation.
std::optional<Eigen::Quaterniond> attitude_of(const msg::StationState& state) {
  const msg::Rotation& given = state.hand_attitude_camera();
  const Eigen::Quaterniond q(given.w(), given.x(), given.y(), given.z());
  if (!(std::abs(q.norm() - 1.0) < 0.01)) return std::nullopt;
  return q.normalized();
}

}  // namespace

Intrinsics scaled_to(const Intrinsics& camera, int width, int height) {
  const double across = static_cast<double>(width) / camera.width, down = static_cast<double>(height) / camera.height;
  return {width,
          height,
          camera.fx * across,
          camera.fy * down,
          (camera.cx + 0.5) * across - 0.5,
          (camera.cy + 0.5) * down - 0.5};
}

bool is_drawable(const msg::StationState& state) {
  return state.has_device_camera() && in_front_of_camera(state.device_camera());
}

Touch touch_of(const msg::StationState& state) {
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
          wire::is_contact(state) ? Force<DepthCamera>{wire::vector_of(state.force_camera_n())} : Force<DepthCamera>{},
          state.indentation_m(),
          state.in_body(),
          attitude_of(state)};
}

std::vector<PanelLine> panel_of(const msg::StationState& state, std::optional<std::int64_t> start_ns) {
  const auto stamp_ns = static_cast<std::int64_t>(state.stamp_ns());
  std::vector<PanelLine> lines{{"state", std::string(words_for(state.phase()).words)},
                               {wire::is_contact(state) ? "force of contact" : "drive, not contact",
                                fixed_text(wire::vector_of(state.force_n()).norm(), 2) + " N"},
                               {"indentation", fixed_text(1e3 * state.indentation_m(), 1) + " mm"}};
  if (state.surface_captured_ns() > 0) {
    const auto age_ns = stamp_ns - static_cast<std::int64_t>(state.surface_captured_ns());
    lines.push_back({"surface age", fixed_text(static_cast<double>(age_ns) * 1e-6, 0) + " ms"});
  }
  if (start_ns) lines.push_back({"time", fixed_text(static_cast<double>(stamp_ns - *start_ns) * 1e-9, 2) + " s"});
  return lines;
}

}  // namespace telepalp::ar
