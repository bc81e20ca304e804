#pragma once

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "haptic_station/device/protocol/udp_device.h"
#include "haptic_station/ports/device.h"
#include "support/program/address.h"

namespace telepalp::device {

/// A device that speaks the protocol of UDP_DEVICE.md, like PC-2, the computer that controls the device in paper S1
/// (docs/sources.md) II.B. This class sends one datagram per tick and receives the device's datagrams, both on the
/// haptic thread with non-blocking calls. A device that reports that its motors are off counts as silent. Only loopback
/// addresses are accepted, because the datagrams are not encrypted. Commands have the version of the newest pose, and
/// version 1 before the first pose.
class UdpDevice final : public ports::Device {
 public:
  /// Error: the address is not a loopback address, or the socket cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<UdpDevice>> open(const program::Address& address);

  /// Commands the device to let go, and waits for a valid pose with its motors on. Error: none came within `limit`.
  [[nodiscard]] Result<void> start(std::chrono::milliseconds limit);

  [[nodiscard]] ports::DeviceReading read() noexcept override;
  void apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double dt_s) noexcept override;

  /// Number of datagrams received so far that were damaged, old, repeated or stale (see udp::PoseOrder). Any thread.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.load(std::memory_order_relaxed); }

  /// The datagrams refused since the last call, as one error: their number, and why the newest one was refused.
  /// nullopt: none. Call it on one thread, not the haptic thread.
  [[nodiscard]] std::optional<Error> new_refusals();

 private:
  using Clock = std::chrono::steady_clock;
  explicit UdpDevice(std::string name);
  enum class Refusal : std::uint8_t { Damaged, Repeated, OldSession, ClockStands };
  void send(udp::Command command) noexcept;
  void note_echo(const udp::Pose& pose) noexcept;
  void take(std::span<const std::byte> datagram) noexcept;
  void refuse(Refusal why) noexcept;

  const std::string name_;
  boost::asio::io_context io_{1};
  boost::asio::ip::udp::socket socket_;
  const std::uint32_t session_;
  std::uint32_t sequence_ = 0;
  std::array<Clock::time_point, 256> sent_at_{};     ///< of the newest commands; index: low bits of the sequence number
  std::optional<Clock::time_point> echoed_sent_at_;  ///< when the command was sent that the newest pose echoes
  udp::PoseOrder order_;
  std::uint16_t version_ = udp::kVersion1;
  ports::DeviceReading newest_;
  Clock::time_point newest_at_;
  bool has_reading_ = false;
  bool faulted_ = false;
  std::atomic<std::uint64_t> refused_{0};                  // written by: haptic thread
  std::atomic<Refusal> newest_refusal_{Refusal::Damaged};  // written by: haptic thread
  std::uint64_t told_ = 0;  // refusals that new_refusals() has returned; owner: its caller
};

}  // namespace telepalp::device
