#include "proto/wire/viewer/viewer_hand.h"

namespace telepalp::wire {
namespace {

/// False for NaN, too.
bool is_near(double coordinate_m) noexcept {
  constexpr double kFurthestHand_m = 10.0;
  return coordinate_m >= -kFurthestHand_m && coordinate_m <= kFurthestHand_m;
}

}  // namespace

std::optional<msg::ViewerHand> read_viewer_hand(const std::string& payload) {
  msg::ViewerHand hand;
  if (payload.size() > kMaxViewerHandBytes || !hand.ParseFromString(payload)) return std::nullopt;
  hand.DiscardUnknownFields();
  if (!hand.has_hand_camera()) return hand.rearm() || hand.accept_object() ? std::optional(hand) : std::nullopt;
  const msg::Vec3& at = hand.hand_camera();
  if (!is_near(at.x()) || !is_near(at.y()) || !is_near(at.z())) return std::nullopt;
  return hand;
}

}  // namespace telepalp::wire
