#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "messages/station.pb.h"
#include "proto/wire/connection/connection.h"
#include "proto/wire/session_clock.h"
#include "proto/words/repeats/repeated_errors.h"
#include "proto/words/repeats/said_once.h"
#include "proto/words/result.h"
#include "server/access/access.h"
#include "server/hub/datagrams/datagram_counts.h"
#include "server/hub/hub.h"
#include "server/hub/places.h"

namespace telepalp::hub {

/// Parses an IP address to listen on, or "localhost". Error: not an IP address, or not a loopback address while
/// `has_keys` is false: without TLS, every machine of the network could read the patient's data.
[[nodiscard]] Result<boost::asio::ip::address> listening_address(const std::string& address, bool has_keys);

class DatagramPort;
class Peer;
struct PeerSite;
enum class Way;

/// Accepts peers (stations, recorders, tools) and connects each to the hub: subscribed messages go to the peer,
/// messages of a station go to the hub. Owner: the server's network thread.
class PeerListener {
 public:
  struct Options {
    std::string address = "127.0.0.1";
    std::uint16_t port = 0;  ///< 0: any free port
    std::string name = "telepalp-server";
    std::shared_ptr<access::Access> access = access::Access::without_keys();  ///< shared with the gateway
    std::optional<Error> no_stations{};  ///< why this server takes no stations; nullopt: it takes them
    PlaceLimits places{};
    IdleLimits idle{};
    std::function<void(const std::string&)> on_note{};           ///< log lines: connected, disconnected and why
    std::function<void(const msg::WindowRequest&)> on_window{};  ///< a station asks for a window; the request is valid
    /// The relays for peers behind the meeting point, with credentials that hold.
    std::function<std::vector<msg::IceRelay>()> relays = [] { return std::vector<msg::IceRelay>{}; };
    std::function<void()> on_leaving{};  ///< called before a peer and its counts leave the hub
  };
  struct Counts {
    std::uint64_t accepted = 0;
    /// Refused peers (bad key, missing right, no free place, or another doctor holds the touch), connections that were
    /// closed because too many had sent no Hello, and pauses in accepting because no file descriptor was free.
    std::uint64_t refused = 0;
    std::uint64_t let_go_idle = 0;       ///< connections closed because they neither received nor published
    std::uint64_t invalid_messages = 0;  ///< invalid messages of peers, dropped
    std::uint64_t over_rate = 0;         ///< messages dropped because the peer exceeded its rate
  };

  [[nodiscard]] static Result<std::unique_ptr<PeerListener>> listen(boost::asio::io_context& io, Hub& hub,
                                                                    const wire::SessionClock& clock, Options options);
  ~PeerListener();

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  [[nodiscard]] std::size_t peers() const noexcept { return peers_.size(); }
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
  /// Number of connected peers that occupy a place for stations (places.h).
  [[nodiscard]] std::size_t stations() const { return taken(PlaceKind::Station); }
  [[nodiscard]] DatagramCounts datagram_counts() const noexcept;
  /// True if depth images may depend on each other: each peer gets them over TCP, or by a path that loses hardly any
  /// datagram or repairs lost ones in time.
  [[nodiscard]] bool references_arrive() const noexcept;
  /// One peer in the hub, and what is known of its line.
  struct PeerLine {
    SubscriberId subscriber = 0;
    std::uint32_t sender = 0;
    PlaceKind kind = PlaceKind::Viewer;
    std::optional<double> share_B_per_s{};  ///< rate that other flows leave; nullopt: none was noticed
    Nanoseconds queue{0};                   ///< standing queue; 0 over TCP
    double dropped = 0.0;                   ///< share of the newest depth images that the line had no room for
  };
  [[nodiscard]] std::vector<PeerLine> lines();
  /// Tells the hub what other flows leave of each peer's line.
  void note_shares();

  /// Takes in a peer whose connection comes through the meeting point, not through this listener's port.
  void admit(boost::asio::ip::tcp::socket socket);
  /// Stops listening, and sends every peer its queued messages and a Goodbye. Within 1 s no work is left in the
  /// io_context.
  void close(const std::string& reason);

 private:
  using PeerNumber = std::uint64_t;

  PeerListener(boost::asio::io_context& io, Hub& hub, const wire::SessionClock& clock, Options options);
  [[nodiscard]] boost::system::error_code open(const boost::asio::ip::tcp::endpoint& endpoint);
  void accept();
  void admit(boost::asio::ip::tcp::socket socket, Way way);
  [[nodiscard]] PeerSite site_for_peers();
  void forget(PeerNumber number);
  [[nodiscard]] std::uint32_t sender_number(std::uint64_t run) const;
  void note(const std::string& text) const;
  void note_refusal(const std::string& text);
  void note_stranger_gone(const std::string& happened, const std::string& reason);
  void note_pause(const boost::system::error_code& why);
  [[nodiscard]] std::size_t taken(std::optional<PlaceKind> kind) const;  ///< nullopt: without a place (places.h)
  [[nodiscard]] std::optional<PeerNumber> stranger_to_close() const;
  void let_a_stranger_go();
  void let_idle_go_every_second();
  void audit_refused_datagrams(std::chrono::steady_clock::time_point now);
  [[nodiscard]] std::unique_ptr<wire::ByteStream> stream_over(boost::asio::ip::tcp::socket socket) const;

  boost::asio::io_context& io_;
  Hub& hub_;
  wire::SessionClock clock_;
  Options options_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  boost::asio::steady_timer second_;
  std::uint16_t port_ = 0;
  std::unique_ptr<DatagramPort> datagrams_;  // the UDP port with the number port_; closed if another program uses it
  std::unique_ptr<const PeerSite> site_;     // what each peer needs of this listener
  std::map<PeerNumber, std::unique_ptr<Peer>> peers_;
  PeerNumber last_number_ = 0;
  Counts counts_;
  SaidOnce said_of_relay_;  // why the relay is of no use
  RepeatedErrors strangers_gone_;
  bool cannot_accept_ = false;  // the last attempt to accept failed
  std::chrono::steady_clock::time_point refusal_noted_{};
  std::chrono::steady_clock::time_point datagrams_audited_{};
  DatagramCounts audited_;  // counts of datagrams already written to the audit log
  std::uint64_t refused_when_noted_ = 0;
};

}  // namespace telepalp::hub
