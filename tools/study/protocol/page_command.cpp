#include "tools/study/protocol/page_command.h"

#include <cmath>
#include <optional>

#include "proto/words/number_word.h"

namespace telepalp::study {
namespace {

constexpr double kMost_mm = 1000.0;

std::optional<double> metres_of(std::string_view text) {
  const std::optional<double> mm = number_of(text);
  return mm && std::abs(*mm) <= kMost_mm ? std::optional(1e-3 * *mm) : std::nullopt;  // NaN compares false
}

Error refused(const char* what, const char* fix) { return {.what = what, .where = "protocol", .fix = fix}; }

}  // namespace

Result<PageCommand> parse_page_command(std::string_view message) {
  if (message == "begin") return PageCommand(BeginPenetration{});
  if (message == "stop") return PageCommand(LetGo{});
  if (message.starts_with("push ")) {
    const auto by_m = metres_of(message.substr(5));
    if (!by_m) return refused("the way of the hand is not one number of at most 1000 mm", "send push WAY, in mm");
    return PageCommand(PushHand{*by_m});
  }
  if (message.starts_with("move ")) {
    const std::string_view numbers = message.substr(5);
    const std::size_t space = numbers.find(' ');
    const auto x = space == std::string_view::npos ? std::nullopt : metres_of(numbers.substr(0, space));
    const auto y = space == std::string_view::npos ? std::nullopt : metres_of(numbers.substr(space + 1));
    if (!x || !y) return refused("the motion is not two numbers of at most 1000 mm", "send move X Y, in mm");
    return PageCommand(MoveHand{{*x, *y}});
  }
  return refused("this is no message of the protocol's page", "send begin, push, move or stop");
}

}  // namespace telepalp::study
