#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "proto/words/frames.h"

namespace telepalp::device::udp {

/// Message from the station to the device, sent at every tick. UDP_DEVICE.md in this folder specifies the bytes.
struct Command {
  std::uint32_t session = 0;   ///< random number that the station chooses at its start
  std::uint32_t sequence = 0;  ///< increases by one with each command
  std::uint64_t sent_us = 0;   ///< on the station's steady clock
  bool in_body = false;        ///< the device point is inside the body; the flag of paper S1 (docs/sources.md) II.C
  bool surface_valid = false;
  bool let_go = false;        ///< the device must neither push nor hold a position
  Point<HapticBase> proxy{};  ///< outside: the device point; in the body: on the surface, at rims in between (S1 II.C)
  double distance_m = 0.0;    ///< of the device point from the surface, negative in the body; S1 II.C
  Vector<HapticBase> normal{};
  Force<HapticBase> force{};  ///< after the station's force limiter
};

/// Message from the device to the station.
struct Pose {
  std::uint32_t session = 0;  ///< random number that the device chooses at its start
  std::uint32_t sequence = 0;
  std::uint64_t taken_us = 0;  ///< when the encoders were read, on the device's clock
  std::uint32_t heard = 0;     ///< sequence number of the newest command received
  bool faulted = false;        ///< the device has switched its motors off by itself
  Point<HapticBase> end_effector{};
  Vector<HapticBase> velocity{};
};

inline constexpr std::size_t kCommandBytes = 108;
inline constexpr std::size_t kPoseBytes = 80;

/// A command with a number that is not finite or is out of range is encoded as a command to let go, with zero force.
[[nodiscard]] std::array<std::byte, kCommandBytes> encode(const Command& command) noexcept;
[[nodiscard]] std::array<std::byte, kPoseBytes> encode(const Pose& pose) noexcept;

/// nullopt: wrong size, magic, version or check sum, unknown flags, or a number that is not finite or out of range: 2 m
/// for each coordinate and the distance, 50 m/s for each component of a velocity, 100 N for each component of a force.
[[nodiscard]] std::optional<Command> decode_command(std::span<const std::byte> datagram) noexcept;
[[nodiscard]] std::optional<Pose> decode_pose(std::span<const std::byte> datagram) noexcept;

/// Decides which poses are new. A pose is newer when its sequence number is greater within the current session, or when
/// it begins a session other than the current and the previous one. A pose whose clock does not advance while its
/// sequence number rises is stale (ClockStands): a hung device must not look alive. Pure.
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
