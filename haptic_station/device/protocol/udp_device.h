#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "proto/words/frames.h"

namespace telepalp::device::udp {

/// What goes down to the device at every tick. UDP_DEVICE.md has the bytes.
struct Command {
  std::uint32_t session = 0;   ///< the station's, drawn at its start
  std::uint32_t sequence = 0;  ///< one more with every command
  std::uint64_t sent_us = 0;   ///< the station's steady clock
  bool in_body = false;        ///< S1 II.C's flag
  bool surface_valid = false;
  bool let_go = false;        ///< no force, no position control
  Point<HapticBase> proxy{};  ///< S1 II.C's proxy
  double distance_m = 0.0;    ///< S1 II.C's distance, negative in the body
  Vector<HapticBase> normal{};
  Force<HapticBase> force{};  ///< already limited
};

/// What comes up from it.
struct Pose {
  std::uint32_t session = 0;  ///< the device's, drawn at its start
  std::uint32_t sequence = 0;
  std::uint64_t taken_us = 0;  ///< the device's own clock, when the encoders were read
  std::uint32_t heard = 0;     ///< the newest command's sequence number
  bool faulted = false;        ///< the device has switched its motors off by itself
  Point<HapticBase> end_effector{};
  Vector<HapticBase> velocity{};
};

inline constexpr std::size_t kCommandBytes = 108;
inline constexpr std::size_t kPoseBytes = 80;

/// Numbers that are not finite, or out of range, become a command to let go, with zero force.
[[nodiscard]] std::array<std::byte, kCommandBytes> encode(const Command& command) noexcept;
[[nodiscard]] std::array<std::byte, kPoseBytes> encode(const Pose& pose) noexcept;

/// nullopt: wrong size, magic, version or check sum, unknown flags, numbers not finite or out of range (2 m, 50 m/s,
/// 100 N).
[[nodiscard]] std::optional<Command> decode_command(std::span<const std::byte> datagram) noexcept;
[[nodiscard]] std::optional<Pose> decode_pose(std::span<const std::byte> datagram) noexcept;

/// Which poses to believe: newer ones of the same session, or of a session that was not heard before the present one.
/// A pose whose clock stands still although its numbers go on is stale: a hung device must not look alive. Pure.
class PoseOrder {
 public:
  enum class Verdict { Newest, Repeated, OldSession, ClockStands };
  [[nodiscard]] Verdict judge(const Pose& pose) noexcept;

 private:
  std::optional<Pose> newest_;
  std::uint32_t session_before_ = 0;
  bool has_session_before_ = false;
};

}  // namespace telepalp::device::udp
