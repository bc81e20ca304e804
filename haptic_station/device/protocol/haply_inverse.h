#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::device::haply {

/// Frame of the Inverse3: origin at its base, right-handed, z up (the service's default basis).
struct InverseBase {};

/// State of one Inverse3, as parsed from a text message of its service.
struct State {
  std::string device_id;
  Point<InverseBase> cursor;
  Vector<InverseBase> velocity;  ///< [m/s]
  /// Rotation from the handle's axes to those of InverseBase, as the service sent it, perhaps of length zero: the
  /// haptic loop bridges such a glitch. nullopt: no handle is listed.
  std::optional<Eigen::Quaterniond> attitude = {};
  /// Any of the buttons of a wireless handle is pressed. nullopt: no such handle is listed.
  std::optional<bool> pressed = {};
};

inline constexpr std::size_t kMostTextBytes = 64U << 10U;

/// Reads one text message of the service: the state of the Inverse3 with the id `wanted_id`, or of the first Inverse3
/// if `wanted_id` is empty. nullopt: the text is well-formed but does not contain this device (it is unplugged) or its
/// state. Error: invalid JSON, over 64 KiB, a field of the wrong type, over 16 devices and handles, an id that is not 1
/// to 64 letters, digits, `-`, `_` or `:`, or a component that is missing, not finite, beyond 2 m in the position or
/// beyond 50 m/s in the velocity.
[[nodiscard]] Result<std::optional<State>> parse_text(std::string_view text, std::string_view wanted_id = {});

/// The text that sets the force at the cursor and requests the next state; the service answers each text with one text.
/// A force that is not finite is sent as zero. Numbers have a decimal point in every locale.
[[nodiscard]] std::string force_text(std::string_view device_id, const Force<InverseBase>& force);

/// Rotates the Inverse3's axes (z up) to those of the haptic base's frame H (y up, as in paper S1, docs/sources.md) and
/// places H's origin, a point of the skin, at `origin`.
[[nodiscard]] Transform<HapticBase, InverseBase> haptic_from_inverse(const Point<InverseBase>& origin);

/// The handle's attitude in the axes of H: both the frame and the tool's axes are turned, so that a handle that lies
/// along the Inverse3's axes has the identity. Its length is kept.
[[nodiscard]] Eigen::Quaterniond in_haptic_axes(const Eigen::Quaterniond& inverse_from_handle);

}  // namespace telepalp::device::haply
