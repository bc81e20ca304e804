#include "haptic_station/station/parts/station_link.h"

#include <array>
#include <cstdio>
#include <utility>

namespace telepalp::station {

StationLink::StationLink(boost::asio::io_context& io, wire::ClientLink::Options options,
                         wire::ClientLink::Handlers handlers, bool own_clock)
    : own_clock_(own_clock),
      link_(io, std::move(options),
            {.on_message = std::move(handlers.on_message),
             .on_state = std::move(handlers.on_state),
             .on_datagrams = std::move(handlers.on_datagrams),
             .on_hand_over = [this](bool done, const std::string& outcome) { hand_over_.on_answer(done, outcome); },
             .on_notice = std::move(handlers.on_notice)}),
      hand_over_(link_) {}

std::optional<std::string> StationLink::line_of(wire::LinkState state, const std::string& detail) {
  const bool trying = state == wire::LinkState::Connecting;
  if (!trying) said_of_trying_.clear();
  std::string text = "link " + std::string(wire::name(state)) + (detail.empty() ? "" : ": " + detail);
  if (trying && !said_of_trying_.insert(text).second) return std::nullopt;
  return text;
}

void StationLink::look_at_clock() noexcept {
  const Nanoseconds bound = own_clock_ ? Nanoseconds{0} : link_.clock_uncertainty();
  clock_error_s_ = bound == Nanoseconds::max() ? std::numeric_limits<double>::infinity() : to_seconds(bound);
}

std::optional<std::string> StationLink::clock_step() {
  const Nanoseconds stepped = link_.clock_stepped();
  const Nanoseconds by = stepped - std::exchange(clock_stepped_, stepped);
  if (by == Nanoseconds{0}) return std::nullopt;
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(),
                "the server's clock stepped by %+.1f s; the contact ends, and can begin again with the next image",
                to_seconds(by));
  return text.data();
}

}  // namespace telepalp::station
