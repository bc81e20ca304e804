#pragma once

#include <functional>
#include <optional>

#include "proto/impaired/impaired_link.h"
#include "proto/impaired/profiles.h"
#include "proto/link/datagram_link.h"

namespace telepalp::impaired {

/// Both ends of a datagram link in one process, and the impaired network between them, in virtual time. Times never
/// decrease. Owner: one thread.
class ImpairedPair {
 public:
  using OnSegment = std::function<void(std::size_t bytes)>;

  /// Begins with a link session of `settings`. `seed`: of the direction from the server; the other one has seed + 1.
  ImpairedPair(SessionTime begin, const Profile& network, std::uint64_t seed,
               const link::DatagramLinkSettings& settings);

  /// Changes the impairments of both directions.
  void change(SessionTime now, const Profile& network) noexcept;
  /// Both ends forget the session before. Its datagrams still arrive, and are refused if `settings` differ from its.
  void begin_link_session(const link::DatagramLinkSettings& settings);

  /// Hands each end the datagrams that have arrived. `on_segment` gets the sizes of the TCP segments among them, which
  /// only the server sends (down()).
  void deliver(SessionTime now, const OnSegment& on_segment = {});
  /// Sends what an end has to send now; returns its bytes, without IP and UDP headers.
  std::size_t transmit_from_server(SessionTime now) { return transmit(*server_, down_, now); }
  std::size_t transmit_from_client(SessionTime now) { return transmit(*client_, up_, now); }
  /// The next arrival, or the next time at which an end has something to send; nullopt: neither.
  [[nodiscard]] std::optional<SessionTime> due(SessionTime now) const;

  [[nodiscard]] link::DatagramLink& server() noexcept { return *server_; }
  [[nodiscard]] link::DatagramLink& client() noexcept { return *client_; }
  /// The direction from the server. Its times count from `begin`.
  [[nodiscard]] ImpairedLink& down() noexcept { return down_; }
  [[nodiscard]] const ImpairedLink& down() const noexcept { return down_; }
  [[nodiscard]] Nanoseconds since_begin(SessionTime now) const noexcept { return now - begin_; }

 private:
  std::size_t transmit(link::DatagramLink& from, ImpairedLink& to, SessionTime now);

  SessionTime begin_;
  ImpairedLink down_;
  ImpairedLink up_;
  std::optional<link::DatagramLink> server_;  // set always
  std::optional<link::DatagramLink> client_;  // set always
};

}  // namespace telepalp::impaired
