#include "haptic_station/station/parts/depth_choice.h"

#include <utility>

#include "proto/wire/topics.h"

namespace telepalp::station {

std::vector<std::string> DepthChoice::topics() const {
  std::vector<std::string> names;
  if (takes_ != Takes::Window) names.emplace_back(wire::kCameraDepth.name);
  if (takes_ != Takes::Whole) names.emplace_back(wire::kCameraDepthWindow.name);
  return names;
}

bool DepthChoice::look(TimePoint now) noexcept {
  if (takes_ != Takes::Window || now - waiting_since_ < kPatience) return false;
  takes_ = Takes::Either;
  return true;
}

DepthChoice::Came DepthChoice::came(std::string_view topic, TimePoint now) {
  Came came;
  if (topic == wire::kCameraDepth.name && takes_ != Takes::Window) {
    came.is_used = true;
    if (takes_ == Takes::Either && !std::exchange(uses_whole_, true))
      came.said =
          "this server sends no depth for --depth window (/camera/depth/window), such as a server that plays a session "
          "or is older than this station: the hand feels whole depth images (/camera/depth), which take more bytes";
  }
  if (topic == wire::kCameraDepthWindow.name && takes_ != Takes::Whole) {
    came.is_used = true;
    waiting_since_ = now;
    came.topics_changed = std::exchange(takes_, Takes::Window) == Takes::Either;
    if (std::exchange(uses_whole_, false))
      came.said = "the server sends depth for --depth window (/camera/depth/window): the hand feels this depth";
  }
  return came;
}

}  // namespace telepalp::station
