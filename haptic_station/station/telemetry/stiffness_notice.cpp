#include "haptic_station/station/telemetry/stiffness_notice.h"

#include <array>
#include <cstdio>

namespace telepalp::station {

std::optional<std::string> StiffnessNotice::look(const loop::Compensation& compensation) {
  const double limit = compensation.stiffest_shown_N_per_m;
  const double asked = compensation.effects_N_per_m;
  if (said_ || !compensation.loop_delay_s || asked <= limit) return std::nullopt;
  said_ = true;
  std::array<char, 400> text{};
  std::snprintf(
      text.data(), text.size(),
      "the device's loop delay is %.1f ms: with it, the device displays at most %.0f N/m without swinging. "
      "The scene asks for %.0f N/m, and the hand feels at most %.0f N/m. fix: let the device's program answer "
      "each command at once, or choose a softer scene",
      1e3 * *compensation.loop_delay_s, limit, asked, limit * asked / (limit + asked));
  return text.data();
}

}  // namespace telepalp::station
