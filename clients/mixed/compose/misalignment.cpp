#include "clients/mixed/compose/misalignment.h"

#include <algorithm>

namespace telepalp::mixed {

std::optional<CouplingEnds> ends_at(std::span<const CouplingEnds> states, SessionTime image,
                                    std::chrono::nanoseconds patience) {
  const auto after = std::find_if(states.begin(), states.end(), [&](const auto& state) { return state.at >= image; });
  if (after == states.end()) {
    if (states.empty() || image - states.back().at > patience) return std::nullopt;
    return states.back();
  }
  if (after->at == image) return *after;
  if (after == states.begin()) return std::nullopt;
  const CouplingEnds& before = *(after - 1);
  if (image - before.at > patience && after->at - image > patience) return std::nullopt;
  const double share = std::chrono::duration<double>(image - before.at) / (after->at - before.at);
  return CouplingEnds{image,
                      {before.device.m + share * (after->device.m - before.device.m)},
                      {before.tool.m + share * (after->tool.m - before.tool.m)}};
}

std::optional<Eigen::Vector2d> hand_shift_px(const View& view, const Point<World>& device,
                                             const Point<World>& tool) noexcept {
  const auto from = image_of(view, device);
  const auto to = image_of(view, tool);
  if (!from || !to) return std::nullopt;
  return *to - *from;
}

}  // namespace telepalp::mixed
