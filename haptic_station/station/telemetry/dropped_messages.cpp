#include "haptic_station/station/telemetry/dropped_messages.h"

namespace telepalp::station {
namespace {

constexpr std::chrono::seconds kBetweenLines{5};
constexpr std::size_t kMostReasons = 16;  // a reason may contain numbers, so that a damaged stream makes many of them

}  // namespace

std::optional<std::string> DroppedMessages::add_image(const Error& error, TimePoint now) {
  ++images_;
  newest_image_ = error;
  return line("depth image", error, now);
}

std::optional<std::string> DroppedMessages::add_unreadable(std::string_view topic, TimePoint now) {
  return line("message",
              {.what = "the message is not of the type of " + std::string(topic) + ", or was cut short",
               .where = std::string(topic),
               .fix = "install the same version of telepalp at server and station"},
              now);
}

std::optional<std::string> DroppedMessages::line(const std::string& kind, const Error& error, TimePoint now) {
  if (reasons_.size() >= kMostReasons && !reasons_.contains(error.what)) reasons_.clear();
  Reason& reason = reasons_[error.what];
  ++reason.messages;
  if (reason.messages > 1 && now < reason.next_line) return std::nullopt;
  reason.next_line = now + kBetweenLines;
  const std::string so_far =
      reason.messages > 1 ? ", " + std::to_string(reason.messages) + " so far for this reason: " : ": ";
  return kind + " dropped" + so_far + to_string(error);
}

}  // namespace telepalp::station
