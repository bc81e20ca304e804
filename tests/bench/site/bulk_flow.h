#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "tests/bench/site/two_networks.h"

namespace telepalp::bench {

/// Traffic of another program on the line, by the kernel's own TCP. It ends with this object.
class BulkFlow {
 public:
  struct Kind {
    std::string congestion = "cubic";  ///< the kernel's name of the algorithm
    bool upload = false;               ///< from the doctor to the patient
    std::uint64_t page_B = 0;          ///< a new connection with so many bytes every 5 s; 0: one without an end
  };
  BulkFlow(const TwoNetworks& networks, Kind kind, std::uint16_t port);
  ~BulkFlow();
  BulkFlow(const BulkFlow&) = delete;
  BulkFlow& operator=(const BulkFlow&) = delete;

  [[nodiscard]] std::uint64_t received_B() const noexcept { return received_B_; }
  /// True if the kernel has no such algorithm: nothing is sent then.
  [[nodiscard]] bool is_unknown() const noexcept { return unknown_; }

 private:
  void receive(const std::stop_token& stop);
  void send(const std::stop_token& stop);
  void send_once(const std::stop_token& stop, int socket);

  Kind kind_;
  std::uint16_t port_;
  std::atomic<std::uint64_t> received_B_ = 0;
  std::atomic<bool> unknown_ = false;
  std::jthread receiver_, sender_;  ///< last: they use the other members
};

}  // namespace telepalp::bench
