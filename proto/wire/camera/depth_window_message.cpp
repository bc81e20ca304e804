#include "proto/wire/camera/depth_window_message.h"

#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {
namespace {

msg::DepthBound to_message(const DepthErrorBound& bound) {
  msg::DepthBound message;
  message.set_least_m(bound.least_m);
  message.set_per_m(bound.per_m);
  return message;
}

DepthErrorBound bound_of(const msg::DepthBound& bound) noexcept {
  return {.least_m = bound.least_m(), .per_m = bound.per_m()};
}

}  // namespace

msg::DepthWindow to_message(const DepthWindow& window) {
  msg::DepthWindow message;
  message.set_column(window.exact.column);
  message.set_row(window.exact.row);
  message.set_width(window.exact.width);
  message.set_height(window.exact.height);
  *message.mutable_near() = to_message(window.near);
  *message.mutable_border() = to_message(window.border);
  return message;
}

std::optional<DepthWindow> window_of(const msg::DepthWindow& window) noexcept {
  const DepthWindow read{
      .exact = {.column = window.column(), .row = window.row(), .width = window.width(), .height = window.height()},
      .near = bound_of(window.near()),
      .border = bound_of(window.border())};
  return is_well_formed(read, kMaxImageSide, kMaxImageSide) ? std::optional(read) : std::nullopt;
}

bool is_valid(const msg::WindowRequest& request) noexcept { return window_of(request.window()).has_value(); }

}  // namespace telepalp::wire
