#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {

/// One direction of the network between server and station, in virtual time or of real sockets. Times are since the
/// session's start and never decrease.
class Wire {
 public:
  virtual ~Wire() = default;
  virtual void send(Nanoseconds now, std::span<const std::byte> datagram) = 0;
  /// The next datagram that has arrived by `now`; nullopt: none.
  [[nodiscard]] virtual std::optional<std::vector<std::byte>> receive(Nanoseconds now) = 0;
  /// Number of lost datagrams; a wire of real sockets counts datagrams on their way, too.
  [[nodiscard]] virtual std::uint64_t lost() const noexcept = 0;
};

/// Both directions. Owner: one run.
struct Wires {
  std::unique_ptr<Wire> down;  ///< from the server to the station
  std::unique_ptr<Wire> up;
};

/// The scenario's network in virtual time. It draws from the same random numbers as telepalp-link with the same seed.
[[nodiscard]] Wires simulated_wires(const Scenario& scenario);

}  // namespace telepalp::replay
