#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/content_choice.h"
#include "server/hub/hub.h"
#include "server/hub/peer_listener.h"
#include "server/origin/origin.h"
#include "server/pipeline/window_choice.h"

namespace telepalp::server {

/// The server without its command line: origin, hub and listener. Runs on `io`'s one thread, the network thread;
/// capturing or playing runs on a separate thread.
class Server {
 public:
  struct Options {
    std::string name = "telepalp-server";
    std::string bind = "127.0.0.1";
    std::uint16_t port = 0;  ///< 0: any free port
    std::string software{};  ///< name, version and commit of the program, for /server/stats; empty: not stated
    std::shared_ptr<access::Access> access = access::Access::without_keys();
    /// The relays for peers behind the meeting point, with credentials that hold.
    std::function<std::vector<msg::IceRelay>()> relays = [] { return std::vector<msg::IceRelay>{}; };
    std::function<void(const std::string&)> log{};  ///< log lines about peers and the camera's state
    /// Of an edge, which shows what another server publishes: that server's session clock. nullopt: no edge.
    std::optional<wire::SessionClock> clock_upstream{};
  };

  /// Opens the port. Messages are published only after start(). Error: the port cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<Server>> listen(boost::asio::io_context& io, Options options);

  /// Publishes the messages of `origin`. `on_end` is called once when no more comes.
  void start(std::unique_ptr<origin::Origin> origin, std::function<void()> on_end);

  /// Publishes the messages of `origin` instead of the present one's. The end of the new one comes to `on_end` of
  /// start().
  void replace(std::unique_ptr<origin::Origin> origin);

  /// Takes in a peer whose connection comes through the meeting point.
  void admit(boost::asio::ip::tcp::socket socket) { listener_->admit(std::move(socket)); }

  /// Stops the origin, sends queued messages and a Goodbye with `reason`. io.run() then returns within 1 s.
  void stop(const std::string& reason);

  [[nodiscard]] std::uint16_t port() const noexcept { return listener_->port(); }
  [[nodiscard]] const wire::SessionClock& clock() const noexcept { return clock_; }
  [[nodiscard]] hub::Hub& hub() noexcept { return hub_; }
  /// Numbers of datagrams that arrived at the UDP port.
  [[nodiscard]] hub::DatagramCounts datagram_counts() const {
    return listener_ ? listener_->datagram_counts() : hub::DatagramCounts{};
  }
  /// The reason why a health check fails, as text; empty: healthy.
  [[nodiscard]] std::string problem() const;
  /// One line with the run's totals, for the end of the program.
  [[nodiscard]] std::string summary() const;

 private:
  Server(boost::asio::io_context& io, Options options);
  void run_origin(std::unique_ptr<origin::Origin> origin);
  void publish(wire::Message message, plan::Grade grade = plan::Grade::Full);
  void tell_origin_what_is_wanted();
  void follow_window(const msg::WindowRequest& request);
  void publish_every_second();
  void show_newcomers_the_picture();
  void publish_clock_and_stats();
  void give_memory_back();
  void choose_prediction();
  void choose_content_often();
  void choose_content();
  void log_state_changes(const wire::Message& status);
  void log(const std::string& text) const;

  boost::asio::io_context& io_;
  Options options_;
  wire::SessionClock clock_;
  hub::Hub hub_;
  pipeline::WindowChoice window_;
  bool window_noted_ = false;  // the log says that another station's window is followed
  std::unique_ptr<hub::PeerListener> listener_;
  boost::asio::steady_timer second_;
  boost::asio::steady_timer content_timer_;
  ContentChoice content_;
  bool stopped_ = false;  // checked by timer handlers: a timer that has expired cannot be cancelled
  std::chrono::steady_clock::time_point last_depth_{};
  std::string last_state_;              // last logged state
  bool predicts_ = true;                // depth images may depend on each other
  std::size_t most_waiting_bytes_ = 0;  // peak of the hub's queues since memory was last released
  std::chrono::steady_clock::time_point started_{};
  std::chrono::steady_clock::time_point shown_since_{};  // origin_, since it was started
  std::unique_ptr<origin::Origin> origin_;               // from start() on
  std::function<void()> on_end_;
};

}  // namespace telepalp::server
