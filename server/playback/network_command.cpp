#include "server/playback/network_command.h"

#include <array>

#include "support/program/message_json.h"

namespace telepalp::playback {
namespace {

constexpr double kMbit_B_per_s = 125'000.0;
constexpr const char* kNetworkExample =
    "send JSON such as {\"profile\": \"lte\"} or {\"delay_ms\": 80, \"loss_percent\": 2}";

struct Bounded {
  const char* name;
  bool given;
  double value;
  double least;
  double most;
};

bool is_within(const Bounded& number) noexcept {
  return !number.given || (number.value >= number.least && number.value <= number.most);
}

Nanoseconds from_ms(double milliseconds) noexcept { return from_seconds(milliseconds * 1e-3); }

void set(impaired::Impairment& impairment, const msg::NetworkCommand& command) {
  if (command.has_delay_ms()) impairment.delay = from_ms(command.delay_ms());
  if (command.has_jitter_ms()) impairment.jitter = from_ms(command.jitter_ms());
  if (command.has_loss_percent()) impairment.loss = command.loss_percent() * 0.01;
  if (command.has_burst_packets()) impairment.burst_packets = command.burst_packets();
  if (command.has_rate_mbit_per_s()) impairment.rate_B_per_s = command.rate_mbit_per_s() * kMbit_B_per_s;
}

}  // namespace

Result<msg::NetworkCommand> read_network_command(const std::string& json) {
  msg::NetworkCommand command;
  if (const Result<void> read = program::read_json(json, command, "playback/network", kNetworkExample); !read)
    return read.error();
  const double rate = command.rate_mbit_per_s();
  const std::array numbers{
      Bounded{"delay_ms is not from 0 to 1000", command.has_delay_ms(), command.delay_ms(), 0.0, 1000.0},
      Bounded{"jitter_ms is not from 0 to 500", command.has_jitter_ms(), command.jitter_ms(), 0.0, 500.0},
      Bounded{"loss_percent is not from 0 to 50", command.has_loss_percent(), command.loss_percent(), 0.0, 50.0},
      Bounded{"burst_packets is not from 1 to 50", command.has_burst_packets(), command.burst_packets(), 1.0, 50.0},
      Bounded{"rate_Mbit_per_s is neither 0 (unlimited) nor from 0.1 to 1000",
              command.has_rate_mbit_per_s() && rate != 0.0, rate, 0.1, 1000.0}};
  for (const Bounded& number : numbers)
    if (!is_within(number)) return Error{.what = number.name, .where = "playback/network", .fix = kNetworkExample};
  return command;
}

Result<ChosenNetwork> after_command(ChosenNetwork chosen, const msg::NetworkCommand& command) {
  if (command.has_profile()) {
    chosen = {};
    if (command.profile() != "none") {
      const Result<impaired::Profile> found = impaired::profile_named(command.profile());
      if (!found)
        return Error{.what = found.error().what, .where = "playback/network", .fix = found.error().fix + ", none"};
      chosen = {.profile = command.profile(), .network = *found};
    }
  }
  chosen.changed = chosen.changed || command.has_delay_ms() || command.has_jitter_ms() || command.has_loss_percent() ||
                   command.has_burst_packets() || command.has_rate_mbit_per_s();
  set(chosen.network.down, command);
  set(chosen.network.up, command);
  return chosen;
}

msg::NetworkState state_of(const ChosenNetwork& chosen) {
  const impaired::Impairment& down = chosen.network.down;
  msg::NetworkState state;
  state.set_profile(chosen.profile);
  state.set_changed(chosen.changed);
  state.set_delay_ms(to_milliseconds(down.delay));
  state.set_jitter_ms(to_milliseconds(down.jitter));
  state.set_loss_percent(down.loss * 100.0);
  state.set_burst_packets(down.burst_packets);
  state.set_rate_mbit_per_s(down.rate_B_per_s / kMbit_B_per_s);
  return state;
}

}  // namespace telepalp::playback
