#include "haptic_station/station/telemetry/dropped_messages.h"

namespace telepalp::station {

std::optional<std::string> DroppedMessages::add_image(const Error& error, TimePoint now) {
  ++images_;
  newest_image_ = error;
  return lines_.line("depth image dropped", error, now);
}

std::optional<std::string> DroppedMessages::add_unreadable(std::string_view topic, TimePoint now) {
  return lines_.line("message dropped",
                     {.what = "the message is not of the type of " + std::string(topic) + ", or was cut short",
                      .where = std::string(topic),
                      .fix = "install the same version of telepalp at server and station"},
                     now);
}

}  // namespace telepalp::station
