#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/ice/ice_paths.h"
#include "proto/ice/words/path_kind.h"
#include "proto/keys/known_list.h"
#include "proto/wire/client/client_outbox.h"
#include "proto/wire/client/client_timers.h"
#include "proto/wire/client/dialer.h"
#include "proto/wire/client/link_clock.h"
#include "proto/wire/connection/connection.h"
#include "proto/wire/datagrams/path_watch.h"
#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "proto/words/repeats/said_once.h"

namespace telepalp::wire {

class ClientDatagrams;

enum class LinkState {
  Connecting,  ///< trying to connect, with back-off between attempts
  Connected,   ///< handshake done, subscribed, session clock synchronised
  Lost,        ///< the connection was lost; Connecting follows automatically
  Refused,     ///< each further attempt would fail the same way; refusal() says why; only Stopped follows
  Stopped,     ///< stop() was called; the final state
};
[[nodiscard]] std::string_view name(LinkState state) noexcept;

/// A client's link to the server, for station, recorder and tools. It connects, subscribes, synchronises the session
/// clock, publishes the client's topics, and reconnects when the server returns. It runs on the io_context's one
/// thread; the caller uses that thread for all methods except clock(), which any thread may call.
///
///   wire::ClientLink link(io, {.port = 4711, .name = "telepalp-record", .subscribes = {"*"}},
///                         {.on_message = [&](const wire::Message& message) { … }});
///   link.start();
///   io.run();
class ClientLink : private ConnectionOwner {
 public:
  struct Options {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;
    std::string site{};           ///< site behind the meeting point `host`; empty: `host` is the server
    std::string name{};           ///< name of this program, for the server's statistics
    std::string role = "viewer";  ///< doctor, recorder, technician, qa, viewer; the server limits the number of each
    std::shared_ptr<const keys::KeyFile> key{};  ///< null: plain TCP, to this machine alone
    std::string consent{};                       ///< the patient's, as whoever watches or records states it
    std::string voice_consent{};                 ///< the patient's consent to record speech; empty: not stated
    std::vector<std::string> subscribes{};       ///< topic names; one ending in '*' is a prefix
    std::vector<Topic> publishes{};  ///< topics that publish() accepts; the server accepts only /station/…
    bool datagrams = true;           ///< takes images and poses by sealed datagram (UDP) if the path carries UDP
    bool accepts_touch = false;      ///< of a station: accepts the touch (see hand_over()) when offered
  };
  struct Handlers {
    std::function<void(const Message&)> on_message{};
    /// `detail`: text for a log line with the peer's address, or the reason why there is no connection.
    std::function<void(LinkState, const std::string& detail)> on_state{};
    /// Called when the phase becomes Up (the images come by datagram) or Blocked (the images come over TCP), and with
    /// Blocked when the first search for a path has found none. `detail`: text for a log line.
    std::function<void(DatagramPhase, const std::string& detail)> on_datagrams{};
    /// The server's answer to hand_over(). `done` is false if the server refuses or the connection ends first.
    std::function<void(bool done, const std::string& outcome)> on_hand_over{};
    /// Something is wrong, without which the session goes on: text for a log line. Called once for each text.
    std::function<void(const std::string& text)> on_notice{};
  };
  struct Counts {
    std::uint64_t connections = 0;  ///< number of times that the state became Connected
    std::uint64_t published = 0;    ///< messages passed to the TCP or UDP socket
    std::uint64_t not_sent = 0;     ///< messages dropped from the queue or published without a connection
  };

  ClientLink(boost::asio::io_context& io, Options options, Handlers handlers);
  ~ClientLink() override;
  ClientLink(const ClientLink&) = delete;
  ClientLink& operator=(const ClientLink&) = delete;

  void start();
  /// Sends queued messages and a Goodbye, and closes the link, within 0.5 s; then it leaves no work in the io_context.
  void stop(const std::string& reason = "the program ends");

  void subscribe(std::vector<std::string> topics);  ///< replaces the subscription; persists over reconnections

  /// Sends `message` to the server with the topic's next sequence number. Returns false without a connection. Then the
  /// message is dropped, because a state that is seconds old is useless; only messages of /station/events are kept for
  /// the next connection.
  bool publish(Message message);

  /// Requests a key frame: `unreadable` (from on_message) cannot be decoded because its reference frame is missing.
  /// Without a connection it does nothing, because the first frame of a new connection is a key frame.
  void request_key_frame(const Message& unreadable);

  /// Offers the touch, the permission to publish as a station, which this station holds, to the doctor named `to`. An
  /// empty name withdraws the offer. The answer comes to on_hand_over. Returns false without a connection.
  bool hand_over(const std::string& to);
  /// The next connection, not the current one, accepts the touch if the touch is offered to this doctor.
  void accept_touch();

  /// The current estimate of the session clock; before the first connection, this machine's wall clock. Any thread.
  /// Call clock() for each reading, because the offset is slewed.
  [[nodiscard]] SessionClock clock() const noexcept { return clock_.clock(); }
  /// Bound on the error of clock() now; Nanoseconds::max() before the first connection and during a new one's first
  /// round trip.
  [[nodiscard]] Nanoseconds clock_uncertainty() const noexcept { return clock_.uncertainty(); }
  /// Sum of the steps of clock(), corrections of 1 s or more, since the first connection. Upward steps are positive.
  [[nodiscard]] Nanoseconds clock_stepped() const noexcept { return clock_.stepped(); }

  [[nodiscard]] LinkState state() const noexcept { return state_; }
  /// In LinkState::Refused: the reason, the server's host and port, and the fix.
  [[nodiscard]] const Error& refusal() const noexcept { return refusal_; }
  /// Why the server does not serve this client for now, in the server's words, such as another doctor who holds the
  /// touch: the newest attempt to connect ended with the server's Goodbye. nullopt: it did not. Error::where is empty.
  [[nodiscard]] const std::optional<Error>& not_served_because() const noexcept { return not_served_because_; }
  /// For a user who waits: that the server does not answer, and why the newest attempt failed.
  [[nodiscard]] std::string no_answer() const {
    return failed_because_.empty() ? "does not answer" : "does not answer (" + failed_because_ + ")";
  }
  /// Connection::keying_material() of the current connection; nullopt without one.
  [[nodiscard]] std::optional<std::array<std::byte, 32>> keying_material(std::string_view label) const;
  /// The phase of the datagram path. In Up the images come by datagram, else over TCP.
  [[nodiscard]] DatagramPhase datagrams() const noexcept;
  /// The way of the datagrams to a server behind the meeting point; nullopt: none was found, or there is no meeting
  /// point.
  [[nodiscard]] std::optional<ice::PathKind> path() const noexcept;
  /// path() and its price, in words; empty: none.
  [[nodiscard]] std::string way() const;
  /// Continues on another local UDP port. For tests: to the server it looks like a NAT that changes its mapping.
  void change_datagram_port();
  [[nodiscard]] Counts counts() const noexcept {
    return {.connections = connections_, .published = outbox_.published(), .not_sent = outbox_.not_sent()};
  }
  /// Received and missed messages by topic, over all connections.
  [[nodiscard]] std::map<std::string_view, ReceivedCount> received() const;

 private:
  bool accepts(const Topic&) override { return true; }
  void on_ready(const msg::Hello& peer) override;
  void on_message(Message message) override;
  void on_subscribe(std::vector<std::string>) override {}  // a server does not subscribe
  void on_clock(const ClockSample& sample) override;
  void on_key_frame_request(const Topic&, SessionTime) override {}  // clients publish no predicted frames
  void on_datagram_offer(const msg::DatagramOffer& offer) override;
  void on_ice_path(const msg::IcePath& message) override;
  void on_hand_over(const msg::HandOver& answer) override;
  void on_revocation_list(const msg::RevocationList& list) override;
  void on_closed(const std::string& reason) override;
  std::optional<Message> next_to_send() override { return outbox_.next(); }
  SessionTime session_now() override { return clock().now(); }
  [[nodiscard]] SessionTime datagram_now() const noexcept;

  void connect();
  void greet(std::unique_ptr<ByteStream> stream);
  void on_connect_failed(const std::string& reason, std::optional<Error> not_served_because = std::nullopt);
  void own_address_lost();
  void refuse(Error why);
  [[nodiscard]] bool trusts_server();
  void retry_later();
  void start_datagrams();
  void find_paths();
  void notice(const std::string& text);
  void on_path(std::optional<ice::PathKind> path);
  void end_datagrams();
  [[nodiscard]] std::string images_come_by(DatagramPhase phase) const;
  void become(LinkState state, const std::string& detail);

  /// The datagrams of the present connection.
  struct Datagrams {
    std::optional<msg::DatagramOffer> offer;   ///< nullopt: the server offers none
    std::unique_ptr<ice::IcePaths> paths;      ///< null: the server's own UDP port is used
    bool has_begun = false;                    ///< the carrier has
    bool said_no_path = false;                 ///< on_datagrams has got that no path was found
    std::unique_ptr<ClientDatagrams> carrier;  ///< null before the clock is synchronised, and without an offer
    Nanoseconds stepped_before{0};             ///< clock_stepped() when `carrier` began
  };
  /// What is under way about the permission to touch.
  struct Touch {
    bool accepts_once = false;  ///< accept_touch() was called, and no connection came since
    bool hands_over = false;    ///< the server's answer to hand_over() has not come
  };

  /// What the client knows of revoked keys, and what the present server has shown of them.
  struct RevokedKeys {
    std::optional<keys::KnownList> known;    ///< nullopt: the client has no key
    std::string parts;                       ///< the parts of a list that is not complete yet
    bool shown = false;                      ///< the server has shown a whole list
    std::optional<Error> why_not_trusted{};  ///< why the present connection ends
  };

  boost::asio::io_context& io_;
  Options options_;
  Handlers handlers_;
  const std::uint64_t run_;  // random number by which a server recognises this link after a reconnection
  Dialer dialer_;
  BackOff back_off_;
  LinkState state_ = LinkState::Stopped;
  Error refusal_;
  std::string failed_because_;  // why the newest attempt to connect failed; empty: it has not
  std::optional<Error> not_served_because_;
  boost::asio::ip::tcp::endpoint server_;   // address and TCP port of the present connection
  std::shared_ptr<Connection> connection_;  // shared with pending operations; null without a connection
  std::string peer_name_;
  LinkClock clock_;
  ClockProber prober_;
  Datagrams datagrams_;
  Touch touch_;
  RevokedKeys revoked_;
  SaidOnce noticed_;
  ClientOutbox outbox_;
  std::map<std::string_view, ReceivedCount> received_before_;
  std::uint64_t connections_ = 0;
};

}  // namespace telepalp::wire
