#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/clock_sync.h"
#include "proto/wire/connection.h"
#include "proto/wire/message.h"
#include "proto/wire/send_queue.h"
#include "proto/wire/session_clock.h"

namespace telepalp::wire {

enum class LinkState {
  Connecting,  ///< trying; again and again, with back-off
  Connected,   ///< greeted, subscribed, and the session clock is known
  Lost,        ///< was Connected; Connecting follows by itself
  Refused,     ///< the server speaks another protocol version; nothing follows but Stopped
  Stopped,     ///< stop() was called; nothing follows
};
[[nodiscard]] std::string_view name(LinkState state) noexcept;

/// Why a program ends at LinkState::Refused. `detail` is the state's, `server` its HOST:PORT.
[[nodiscard]] Error refused_error(const std::string& detail, const std::string& server);

/// What a station, a recorder or a tool holds of a server: connects, subscribes, keeps the session clock, publishes
/// its own topics upstream, and comes back by itself when the server does. Runs on the io_context's one thread;
/// every method is called on it, but clock(), which any thread may ask.
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
    std::string name{};                     ///< of this program; the server's statistics list it
    std::string role = "viewer";            ///< doctor, recorder, technician, qa, viewer: what place it is given
    std::vector<std::string> subscribes{};  ///< topic names; one ending in '*' is a prefix
    std::vector<Topic> publishes{};         ///< what publish() may be given; the server takes only /station/…
  };
  struct Handlers {
    std::function<void(const Message&)> on_message{};
    /// `detail` is for people: whom it is connected to, or why not.
    std::function<void(LinkState, const std::string& detail)> on_state{};
  };
  struct Counts {
    std::uint64_t connections = 0;  ///< times that Connected was reached
    std::uint64_t published = 0;    ///< handed to the socket
    std::uint64_t not_sent = 0;     ///< overtaken in the queue, or published while there was no connection
  };

  ClientLink(boost::asio::io_context& io, Options options, Handlers handlers);
  ~ClientLink() override;
  ClientLink(const ClientLink&) = delete;
  ClientLink& operator=(const ClientLink&) = delete;

  void start();
  /// Sends what is queued, says Goodbye and tries no more; all that within half a second, then io_context::run() ends.
  void stop(const std::string& reason = "done");

  void subscribe(std::vector<std::string> topics);  ///< replaces; kept over reconnections

  /// Sends `message` upstream, numbered by topic. False: there is no connection; only /station/events wait for the
  /// next one, since a state that is seconds old serves nobody.
  bool publish(Message message);

  /// Tells the server that `unreadable`, as on_message gave it, cannot be read without the one before it, which is not
  /// at hand. One that stands alone follows soon. Nothing while there is no connection: after one, it comes anyway.
  void want_key(const Message& unreadable);

  /// The session clock as known now; before the first connection, this machine's wall-clock guess. Any thread.
  /// Ask again for each reading: the offset within is slewed, and so changes with time.
  [[nodiscard]] SessionClock clock() const noexcept;
  /// How far clock() may be from the truth.
  [[nodiscard]] Nanoseconds clock_uncertainty() const noexcept { return clock_sync_.uncertainty(); }

  [[nodiscard]] LinkState state() const noexcept { return state_; }
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
  /// By topic, over all connections.
  [[nodiscard]] std::map<std::string_view, ReceivedCount> received() const;

 private:
  bool accepts(const Topic&) override { return true; }
  void on_ready(const msg::Hello& peer) override;
  void on_message(Message message) override;
  void on_subscribe(std::vector<std::string>) override {}  // a server takes what it is sent
  void on_clock(const ClockSample& sample) override;
  void on_want_key(const Topic&, SessionTime) override {}  // what a client publishes stands alone
  void on_closed(const std::string& reason) override;
  std::optional<Message> next_to_send() override;
  SessionTime session_now() override { return clock().now(); }

  /// `handler`, made to do nothing once this link is gone: the io_context may still hold it then.
  template <class Handler>
  auto while_alive(Handler handler) {
    return [alive = std::weak_ptr<const bool>(alive_), handler = std::move(handler)](const auto&... arguments) {
      if (!alive.expired()) handler(arguments...);
    };
  }

  void connect();
  void resolve();
  void connect_to(const boost::asio::ip::tcp::endpoint& endpoint);
  void on_connect_failed(const std::string& reason);
  void retry_later();
  void probe_later();
  void become(LinkState state, const std::string& detail);

  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // shared with pending handlers, as a sign
  boost::asio::io_context& io_;
  Options options_;
  Handlers handlers_;
  const std::uint64_t run_;  // by it a server knows this link again after a reconnection
  LinkState state_ = LinkState::Stopped;
  std::shared_ptr<Connection> connection_;  // shared with its pending operations; null between connections
  std::string peer_name_;
  boost::asio::ip::tcp::resolver resolver_;
  boost::asio::ip::tcp::socket connecting_;
  boost::asio::steady_timer retry_;
  boost::asio::steady_timer probe_;
  std::chrono::milliseconds back_off_;
  ClockSync clock_sync_;
  std::atomic<std::int64_t> offset_target_ns_;           // SlewedOffset, written by the network thread, read by any:
  std::atomic<std::int64_t> offset_line_at_zero_ns_{0};  // written before the target and read after it
  int probes_ = 0;                                       // on this connection
  SendQueue outgoing_;
  std::map<std::string_view, std::uint64_t> sequences_;  // last number given, by topic
  std::map<std::string_view, ReceivedCount> received_before_;
  Counts counts_;
};

}  // namespace telepalp::wire
