#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "proto/link/datagram_link.h"
#include "tools/replay/cell/wire.h"

namespace telepalp::replay {

enum Channel : std::uint8_t { kDepthChannel, kColorChannel };

/// Counters of one run's network.
struct PathCounts {
  std::uint64_t sent_B = 0;      ///< from the server to the station, without IP and UDP headers
  std::uint64_t answered_B = 0;  ///< in the other direction
  std::uint64_t lost = 0;        ///< the server's datagrams that the network lost or dropped, except in outages
};

/// Both ends of the datagram link and the impaired network between them. Times are session times; a run starts at
/// kBegin (scenario.h). Owner: one run.
class CameraPath {
 public:
  CameraPath(const Scenario& scenario, Wires wires);

  /// Queues `frame` at the server. True: `frame` replaced an earlier frame, which is never sent.
  bool offer(link::Frame frame);
  /// Delivers the datagrams that have arrived, and sends those that are due. Call it once a tick.
  void exchange(SessionTime now);
  /// The next frame that is complete at the station; nullopt: none.
  [[nodiscard]] std::optional<link::Frame> take(SessionTime now);
  /// The station's request for a depth key frame, which reaches the server after the network's delay.
  void request_key_frame(SessionTime now);
  /// True if a request of the station, or of its end of the link, has reached the server. The call clears them.
  [[nodiscard]] bool key_frame_wanted(SessionTime now);
  /// True while the server restarts (Faults::restarts).
  [[nodiscard]] bool server_is_away(SessionTime now) const noexcept;
  [[nodiscard]] const PathCounts& counts() const noexcept { return counts_; }

 private:
  struct Ends {
    link::DatagramLink server;
    link::DatagramLink station;
  };
  void begin_link_session();
  void deliver(Wire& from, link::DatagramLink& to, SessionTime now);
  std::uint64_t transmit(link::DatagramLink& from, Wire& to, SessionTime now);

  const Scenario scenario_;
  Wires wires_;
  std::unique_ptr<Ends> ends_;
  std::uint32_t link_sessions_ = 0;
  bool was_away_ = false;
  std::optional<SessionTime> key_frame_request_;  ///< when the station's request reaches the server
  PathCounts counts_;
};

}  // namespace telepalp::replay
