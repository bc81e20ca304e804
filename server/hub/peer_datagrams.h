#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proto/ice/ice_paths.h"
#include "proto/wire/datagrams/datagram_end.h"
#include "proto/wire/datagrams/datagram_offer.h"
#include "server/hub/datagrams/datagram_port.h"
#include "server/hub/datagrams/proved_address.h"
#include "server/hub/hub.h"

namespace telepalp::hub {

/// The datagrams of one peer. While the peer answers datagrams, they carry the deadline topics, whose late messages are
/// of no use (Topic::datagram_channel), in both directions; TCP carries the other topics. Owner: the network thread.
class PeerDatagrams : private DatagramPort::Session {
 public:
  struct Peer {
    SubscriberId subscriber = 0;
    std::function<SessionTime()> now{};
    /// Called for each message that comes by datagram; empty: the peer may publish nothing, its frames are ignored.
    std::function<void(wire::Message)> on_message{};
    std::function<void(wire::DatagramPhase)> on_phase{};  ///< called when the phase becomes Up or Blocked
    /// Of a peer behind the meeting point: sends it a message about a path. Empty function: the peer knows this
    /// server's UDP port.
    std::function<void(const msg::IcePath&)> signal{};
    std::function<std::vector<msg::IceRelay>()> relays = [] { return std::vector<msg::IceRelay>{}; };
    std::function<void(const Error&)> on_unused_relay = [](const Error&) {};  ///< as ice::IcePaths::Handlers
  };

  /// Offers datagrams to the peer. nullptr: the peer wants no datagrams, or names an unknown cipher.
  static std::unique_ptr<PeerDatagrams> offer(boost::asio::io_context& io, DatagramPort& port, Hub& hub,
                                              msg::DatagramCipher wanted, const wire::KeyingMaterial& from_tls,
                                              Peer peer);
  ~PeerDatagrams() override;

  /// The offer to send to the peer over TCP, once.
  [[nodiscard]] const msg::DatagramOffer& message() const noexcept { return offer_.message; }
  /// Call it once the offer is on its way.
  void start();
  /// The peer's message about a path.
  void on_ice_path(const msg::IcePath& message) {
    if (paths_) paths_->heard(message);
  }
  /// The way of the datagrams and its price, in words; empty: they go to the peer's UDP address, or there is no path.
  [[nodiscard]] std::string way() const;
  /// Leaves the port; afterwards no handler is called. The closed object may outlive port and hub. A handler must not
  /// destroy the object that calls it.
  void close() noexcept;
  /// True if the depth images for this peer may be predicted from each other: they go over TCP, or the path of their
  /// datagrams loses hardly any packet, or a loss is repaired within the deadline (link::references_arrive()).
  [[nodiscard]] bool references_arrive() const noexcept;
  /// What the path of the datagrams still carries beside other flows (link::PathEstimate::share_B_per_s()) [B/s];
  /// nullopt: no other flow was noticed, or TCP carries the images.
  [[nodiscard]] std::optional<double> share_B_per_s() const noexcept;
  /// The same, but at most what was delivered in the last second (link::PathEstimate::delivered_share_B_per_s()).
  [[nodiscard]] std::optional<double> delivered_share_B_per_s() const noexcept;
  /// The path's standing queue (link::PathEstimate::queue_delay()); 0 while TCP carries the images.
  [[nodiscard]] Nanoseconds queue() const noexcept;
  /// Call it when the hub has a message for the peer.
  void wake() { end_->pump(); }

 private:
  PeerDatagrams(DatagramPort& port, Hub& hub, Peer peer);
  void received(std::span<const std::byte> datagram, const DatagramPort::Endpoint& from) override;
  [[nodiscard]] const link::OpenerStatistics& refused() const override { return end_->link().opener(); }
  void on_phase(wire::DatagramPhase phase);
  /// nullptr: TCP carries the images.
  [[nodiscard]] const link::PathEstimate* path() const noexcept;
  [[nodiscard]] bool carries_images() const noexcept;
  [[nodiscard]] bool is_proved() const noexcept;
  [[nodiscard]] bool send(std::span<const std::byte> datagram);
  void find_paths(boost::asio::io_context& io);
  void on_path(std::optional<ice::PathKind> path);
  void prove(const DatagramPort::Endpoint& from, std::size_t bytes);

  DatagramPort& port_;
  Hub& hub_;
  Peer peer_;
  std::uint32_t number_;
  wire::DatagramOffer offer_;
  bool closed_ = false;
  ProvedAddress address_;
  std::unique_ptr<ice::IcePaths> paths_;    // null: the datagrams go to address_
  bool has_begun_ = false;                  // end_ has
  std::unique_ptr<wire::DatagramEnd> end_;  // never null after offer()
};

}  // namespace telepalp::hub
