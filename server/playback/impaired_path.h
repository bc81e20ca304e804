#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "proto/impaired/impaired_pair.h"
#include "proto/wire/datagram_message.h"

namespace telepalp::playback {

/// The messages of a played session on their way through an impaired network. Those of the topics with a deadline
/// (Topic::datagram_channel) cross it as sealed datagrams, with the loss repair of link::DatagramLink; the other
/// messages cross it as segments of one TCP stream. Pure: time is an argument and never decreases. Owner: the network
/// thread.
class ImpairedPath {
 public:
  /// Limit for the bytes of the TCP stream's messages that have not arrived; further messages are dropped.
  static constexpr std::size_t kMostWaiting_B = std::size_t{8} << 20U;

  ImpairedPath(SessionTime now, const impaired::Profile& network, std::uint64_t seed);

  /// Changes the impairments of both directions. The datagram link begins a new session, as after a reconnect, and so
  /// forgets its estimate of the former path; its datagrams on the way are lost. The TCP stream goes on.
  void change(SessionTime now, const impaired::Profile& network);
  /// Takes a message. The caller numbers the messages of each deadline topic without a gap (`message.sequence`).
  void send(SessionTime now, wire::Message message);
  /// The messages that have arrived by `now`. A predicted depth image arrives only after the image before it. A message
  /// by datagram that arrives after a newer one of its topic is left out.
  [[nodiscard]] std::vector<wire::Message> receive(SessionTime now);
  /// When to call receive() again; nullopt: only after send().
  [[nodiscard]] std::optional<SessionTime> due(SessionTime now) const;

  /// Ends the TCP stream: returns its messages that have not arrived, in order. The datagrams on the way are lost.
  [[nodiscard]] std::vector<wire::Message> end();

  /// Counts of the direction from the patient's site.
  [[nodiscard]] const impaired::LinkStatistics& statistics() const noexcept { return network_.down().statistics(); }
  /// Number of depth images that were left out, because a newer one had arrived before.
  [[nodiscard]] std::uint64_t late_images() const noexcept { return late_images_; }

 private:
  struct Segmented {
    wire::Message message;
    std::size_t unsent_B;
    std::size_t missing_B;  ///< not arrived yet
  };
  using Waiting = std::deque<wire::Message>;
  void wait_for_link(wire::Message message);
  [[nodiscard]] bool offer_next(SessionTime now);
  void transmit(SessionTime now);
  void send_segments(SessionTime now);
  void deliver_frames(SessionTime now, std::vector<wire::Message>& arrived);
  void deliver_segment(std::size_t bytes, std::vector<wire::Message>& arrived);

  std::uint32_t link_session_ = 0;
  impaired::ImpairedPair network_;           // the server is the patient's site
  std::map<std::uint8_t, Waiting> waiting_;  // by datagram channel
  std::deque<Segmented> stream_;
  std::size_t stream_B_ = 0;
  std::uint64_t late_images_ = 0;
};

}  // namespace telepalp::playback
