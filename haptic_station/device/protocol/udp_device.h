#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "haptic_station/ports/readings.h"
#include "proto/words/frames.h"
#include "proto/words/wrench.h"

namespace telepalp::device::udp {

/// Versions of the protocol. Version 2 adds attitude and torque.
inline constexpr std::uint16_t kVersion1 = 1;
inline constexpr std::uint16_t kVersion2 = 2;

/// Message from the station to the device, sent at every tick. UDP_DEVICE.md in this folder specifies the bytes.
struct Command {
  std::uint16_t version = kVersion1;
  std::uint32_t session = 0;   ///< random number that the station chooses at its start
  std::uint32_t sequence = 0;  ///< increases by one with each command
  std::uint64_t sent_us = 0;   ///< on the station's steady clock
  bool in_body = false;        ///< the device point is inside the body; the flag of paper S1 (docs/sources.md) II.C
  bool surface_valid = false;
  bool let_go = false;        ///< the device must neither push nor hold a position
  Point<HapticBase> proxy{};  ///< outside: the device point; in the body: on the surface, at rims in between (S1 II.C)
  double distance_m = 0.0;    ///< of the device point from the surface, negative in the body; S1 II.C
  Vector<HapticBase> normal{};
  Force<HapticBase> force{};    ///< after the station's force limiter
  Torque<HapticBase> torque{};  ///< the same; version 2 only
};

/// Message from the device to the station.
struct Pose {
  std::uint16_t version = kVersion1;
  std::uint32_t session = 0;  ///< random number that the device chooses at its start
  std::uint32_t sequence = 0;
  std::uint64_t taken_us = 0;  ///< when the encoders were read, on the device's clock
  std::uint32_t heard = 0;     ///< sequence number of the newest command received
  bool faulted = false;        ///< the device has switched its motors off by itself
  bool pressed = false;        ///< the hand presses the device's button
  Point<HapticBase> end_effector{};
  Vector<HapticBase> velocity{};
  /// The next three: version 2 only. `attitude` is as the device sent it, perhaps not finite or of length zero: the
  /// haptic loop bridges such a glitch. nullopt: the device measures none.
  std::optional<Eigen::Quaterniond> attitude{};
  Vector<HapticBase> turning{};  ///< angular velocity [rad/s]
  ports::DevicePower power{};
};

/// The bytes of a datagram, whose number depends on the version.
class Datagram {
 public:
  static constexpr std::size_t kMostBytes = 152;
  explicit Datagram(std::size_t size) noexcept : size_(size) {}
  [[nodiscard]] std::byte* data() noexcept { return bytes_.data(); }
  [[nodiscard]] const std::byte* data() const noexcept { return bytes_.data(); }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::byte* begin() noexcept { return data(); }
  [[nodiscard]] std::byte* end() noexcept { return data() + size_; }
  [[nodiscard]] const std::byte* begin() const noexcept { return data(); }
  [[nodiscard]] const std::byte* end() const noexcept { return data() + size_; }
  [[nodiscard]] std::byte& operator[](std::size_t i) noexcept { return bytes_[i]; }
  [[nodiscard]] const std::byte& operator[](std::size_t i) const noexcept { return bytes_[i]; }

 private:
  std::array<std::byte, kMostBytes> bytes_{};
  std::size_t size_;
};

/// A command with a number that is not finite or is out of range is encoded as a command to let go, with zero force.
[[nodiscard]] Datagram encode(const Command& command) noexcept;
[[nodiscard]] Datagram encode(const Pose& pose) noexcept;

/// nullopt: wrong size, magic, version or check sum, unknown flags, or a number that is not finite or out of range: 2 m
/// for each coordinate and the distance, 50 m/s for each component of a velocity, 100 N for each component of a force,
/// 10 N m for each component of a torque, 200 rad/s for each component of an angular velocity. An attitude is passed on
/// as it is.
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
