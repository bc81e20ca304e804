#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <span>
#include <thread>

#include "haptic_station/device/protocol/udp_device.h"

namespace telepalp::device {

/// A device's program on a real socket. It answers each command with a pose, and has faults on request.
class FakeUdpDevice {
 public:
  enum class Fault { None, Silent, NaN, Hung, MotorsOff, Garbage };

  explicit FakeUdpDevice(std::uint16_t port = 0)
      : socket_(io_, {boost::asio::ip::address_v4::loopback(), port}), port_(socket_.local_endpoint().port()) {
    socket_.non_blocking(true);
    thread_ = std::thread([this] {
      while (running_) turn();
    });
  }
  ~FakeUdpDevice() {
    running_ = false;
    thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  std::atomic<Fault> fault{Fault::None};
  std::atomic<double> force_y{0.0};
  std::atomic<double> distance{0.0};
  std::atomic<std::uint32_t> session{77};
  std::atomic<std::uint16_t> version{udp::kVersion1};  ///< of its poses
  std::atomic<std::uint16_t> heard_version{0};         ///< of the newest command
  std::atomic<double> torque_z{0.0};
  std::atomic<std::chrono::milliseconds> holds{std::chrono::milliseconds(0)};  ///< time from a command to its answer
  std::atomic<std::uint32_t> misheard{0};  ///< added to the sequence number that its poses echo

 private:
  void turn() {
    std::array<std::byte, 256> datagram;
    boost::asio::ip::udp::endpoint from;
    boost::system::error_code error;
    const std::size_t size = socket_.receive_from(boost::asio::buffer(datagram), from, 0, error);
    if (error) return std::this_thread::sleep_for(std::chrono::microseconds(100));
    const auto heard = udp::decode_command(std::span(datagram).first(size));
    if (!heard) return;
    force_y = heard->force.N.y();
    distance = heard->distance_m;
    torque_z = heard->torque.N_m.z();
    heard_version = heard->version;
    answer(from, *heard);
  }
  void answer(const boost::asio::ip::udp::endpoint& to, const udp::Command& heard) {
    const Fault wrong = fault;
    if (wrong == Fault::Silent) return;
    std::this_thread::sleep_for(holds.load());
    ++sequence_;
    if (wrong != Fault::Hung) clock_us_ += 500;
    udp::Pose pose{.session = session,
                   .sequence = sequence_,
                   .taken_us = clock_us_,
                   .heard = heard.sequence + misheard,
                   .faulted = wrong == Fault::MotorsOff,
                   .end_effector = {{0.01, -0.02, 0.03}},
                   .velocity = {{0, 0, 0}}};
    pose.version = version;
    if (version == udp::kVersion2) {
      pose.attitude = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
      pose.turning.v.z() = 0.25;
      pose.power = {.most_N = 8.0, .most_N_m = 0.5};
    }
    if (wrong == Fault::NaN) pose.end_effector.m.x() = std::nan("");
    auto bytes = udp::encode(pose);
    if (wrong == Fault::Garbage) std::ranges::fill(bytes, std::byte{0x55});
    boost::system::error_code ignored;
    (void)socket_.send_to(boost::asio::buffer(bytes.data(), bytes.size()), to, 0, ignored);
  }

  boost::asio::io_context io_;
  boost::asio::ip::udp::socket socket_;
  std::uint16_t port_;
  std::uint32_t sequence_ = 0;
  std::uint64_t clock_us_ = 0;
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace telepalp::device
