#include "haptic_station/device/protocol/udp_socket_device.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/address.hpp>
#include <limits>
#include <random>
#include <thread>
#include <utility>

#include "proto/words/counted.h"

namespace telepalp::device {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr int kMostDatagramsATick = 16;

}  // namespace

UdpDevice::UdpDevice(std::string name)
    : name_(std::move(name)), socket_(io_), session_(static_cast<std::uint32_t>(std::random_device{}())) {}

Result<std::unique_ptr<UdpDevice>> UdpDevice::open(const program::Address& address) {
  const std::string name = "device udp:" + address.host + ":" + std::to_string(address.port);
  error_code error;
  const asio::ip::address ip =
      address.host == "localhost" ? asio::ip::address_v4::loopback() : asio::ip::make_address(address.host, error);
  if (error || !ip.is_loopback())
    return Error{
        .what = "is not a loopback address; device datagrams are not encrypted, so they may not leave this computer",
        .where = name,
        .fix = "run the device's program on this computer and give udp:127.0.0.1:PORT"};
  std::unique_ptr<UdpDevice> device(new UdpDevice(name));
  const asio::ip::udp::endpoint there(ip, address.port);
  device->socket_.open(there.protocol(), error);
  if (!error) device->socket_.connect(there, error);
  if (!error) device->socket_.non_blocking(true, error);
  if (error)
    return Error{
        .what = "cannot open a UDP socket: " + error.message(), .where = name, .fix = "check the address and the port"};
  return device;
}

Result<void> UdpDevice::start(std::chrono::milliseconds limit) {
  const Clock::time_point until = Clock::now() + limit;
  while (Clock::now() < until) {
    send({.let_go = true});
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (read().age_s < 1.0) return {};
  }
  const std::string why = faulted_        ? "reports that its motors are off"
                          : refused() > 0 ? "answers with datagrams that break the protocol in telepalp's UDP_DEVICE.md"
                                          : "does not answer";
  const std::string fix =
      faulted_        ? "switch the device's motors on"
      : refused() > 0 ? "run a program for the device that keeps to this protocol"
                      : "start the device's program, which must keep to the protocol in telepalp's UDP_DEVICE.md";
  return Error{.what = why, .where = name_, .fix = fix + ", or try the station without a device by --device simulated"};
}

ports::DeviceReading UdpDevice::read() noexcept {
  std::array<std::byte, 256> datagram;
  for (int i = 0; i < kMostDatagramsATick; ++i) {
    error_code error;
    const std::size_t size = socket_.receive(asio::buffer(datagram), 0, error);
    if (error == asio::error::would_block || error == asio::error::try_again) break;
    if (error) continue;  // "connection refused", once for each datagram sent; the reading's age shows the silence
    take(std::span(datagram).first(size));
  }
  ports::DeviceReading reading = newest_;
  if (echoed_sent_at_) reading.loop_s = std::chrono::duration<double>(Clock::now() - *echoed_sent_at_).count();
  // A device whose motors are off gives no force, so the watchdog treats it as silent.
  reading.age_s = has_reading_ && !faulted_ ? std::chrono::duration<double>(Clock::now() - newest_at_).count()
                                            : std::numeric_limits<double>::infinity();
  return reading;
}

void UdpDevice::take(std::span<const std::byte> datagram) noexcept {
  const auto pose = udp::decode_pose(datagram);
  if (!pose) return refuse(Refusal::Damaged);
  switch (order_.judge(*pose)) {
    case udp::PoseOrder::Verdict::Newest:
      break;
    case udp::PoseOrder::Verdict::Repeated:
      return refuse(Refusal::Repeated);
    case udp::PoseOrder::Verdict::OldSession:
      return refuse(Refusal::OldSession);
    case udp::PoseOrder::Verdict::ClockStands:
      return refuse(Refusal::ClockStands);
  }
  newest_ = {.at = pose->end_effector,
             .velocity = pose->velocity,
             .attitude = pose->attitude,
             .turning = pose->turning,
             .pressed = pose->pressed,
             .power = pose->power};
  note_echo(*pose);
  version_ = pose->version;
  newest_at_ = Clock::now();
  faulted_ = pose->faulted;
  has_reading_ = true;
}

/// A pose names the newest command that its device had received when it read the encoders.
void UdpDevice::note_echo(const udp::Pose& pose) noexcept {
  const std::uint32_t since = sequence_ - pose.heard;  // also across a wrap-around
  echoed_sent_at_.reset();
  if (since < sent_at_.size() && since < sequence_) echoed_sent_at_ = sent_at_[pose.heard % sent_at_.size()];
}

void UdpDevice::refuse(Refusal why) noexcept {
  newest_refusal_.store(why, std::memory_order_relaxed);
  refused_.fetch_add(1, std::memory_order_relaxed);
}

std::optional<Error> UdpDevice::new_refusals() {
  const std::uint64_t refused = this->refused(), since = refused - std::exchange(told_, refused);
  if (since == 0) return std::nullopt;
  const char* why = "";
  switch (newest_refusal_.load(std::memory_order_relaxed)) {
    case Refusal::Damaged:
      why = "it is damaged, or holds a number that is out of range";
      break;
    case Refusal::Repeated:
      why = "its sequence number does not rise";
      break;
    case Refusal::OldSession:
      why = "it is of the device's session before this one";
      break;
    case Refusal::ClockStands:
      why = "the device's clock does not advance: the device's program hangs";
      break;
  }
  return Error{.what = counted(since, "datagram", "datagrams") + " refused; the newest because " + why,
               .where = name_,
               .fix = "run a program for the device that keeps to the protocol in telepalp's UDP_DEVICE.md"};
}

void UdpDevice::apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact& contact, double) noexcept {
  send({.in_body = contact.in_body,
        .surface_valid = contact.valid,
        .proxy = contact.proxy,
        .distance_m = contact.distance_m,
        .normal = contact.normal,
        .force = wrench.force,
        .torque = wrench.torque});
}

void UdpDevice::send(udp::Command command) noexcept {
  const Clock::time_point now = Clock::now();
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  command.version = version_;
  command.session = session_;
  command.sequence = ++sequence_;
  sent_at_[sequence_ % sent_at_.size()] = now;
  command.sent_us = static_cast<std::uint64_t>(since.count());
  error_code ignored;  // the reading's age shows that the device is away
  const udp::Datagram datagram = udp::encode(command);
  (void)socket_.send(asio::buffer(datagram.data(), datagram.size()), 0, ignored);
}

}  // namespace telepalp::device
