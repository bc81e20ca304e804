#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::device::haply {

/// The Inverse3's own frame: origin at its base, right-handed, z up (the service's default basis).
struct InverseBase {};

/// One Inverse3 as a text tells of it.
struct State {
  std::string device_id;
  Point<InverseBase> cursor;
  Vector<InverseBase> velocity;  ///< [m/s]
};

inline constexpr std::size_t kMostTextBytes = 64U << 10U;

/// Reads one text of the service: the Inverse3 named `wanted_id`, or the first one if that is empty. nullopt: the text
/// is well-formed, but this device is not in it (unplugged), or its state is not.
/// Error: no JSON, over 64 KiB, a field of the wrong type, an id of over 64 bytes or with anything but letters, digits,
/// `-`, `_` and `:`, a position beyond 2 m or a speed beyond 50 m/s, numbers that are not finite.
[[nodiscard]] Result<std::optional<State>> parse_text(std::string_view text, std::string_view wanted_id = {});

/// The text that sets the force at the cursor, and asks for the next state: the service answers each text by one.
/// A force that is not finite is sent as zero. Numbers have a point whatever the locale.
[[nodiscard]] std::string force_text(std::string_view device_id, const Force<InverseBase>& force);

/// Turns the Inverse's axes (z up) into H's (y up, S1), with H's origin at `origin`: where the skin shall be.
[[nodiscard]] Transform<HapticBase, InverseBase> haptic_from_inverse(const Point<InverseBase>& origin);

}  // namespace telepalp::device::haply
