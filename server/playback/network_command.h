#pragma once

#include <string>

#include "messages/playback.pb.h"
#include "proto/impaired/profiles.h"
#include "proto/words/result.h"

namespace telepalp::playback {

/// The network that a played session crosses: a named profile; commands may have changed its numbers.
struct ChosenNetwork {
  std::string profile = "none";  ///< "none": no impairment
  bool changed = false;          ///< numbers were changed after the profile was chosen
  impaired::Profile network{};
  [[nodiscard]] bool impairs() const noexcept { return changed || profile != "none"; }
};

/// Parses a NetworkCommand from JSON. Error: the text is not JSON, has an unknown field, or a value is out of its
/// range.
[[nodiscard]] Result<msg::NetworkCommand> read_network_command(const std::string& json);

/// `chosen` after `command`, whose numbers apply to both directions. Error: no profile has the given name.
[[nodiscard]] Result<ChosenNetwork> after_command(ChosenNetwork chosen, const msg::NetworkCommand& command);

/// `chosen` as a NetworkState: the impairments of the direction from server to client. All counts are 0.
[[nodiscard]] msg::NetworkState state_of(const ChosenNetwork& chosen);

}  // namespace telepalp::playback
