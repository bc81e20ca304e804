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
#include "server/capture/capture_source.h"
#include "server/hub/hub.h"
#include "server/hub/peer_listener.h"
#include "server/pipeline/capture_thread.h"
#include "server/playback/session_network.h"
#include "server/playback/session_player.h"

namespace telepalp::server {

/// The server without its command line: capture source, hub and listener. Runs on `io`'s one thread, the network
/// thread; capturing runs on a separate thread.
class Server {
 public:
  struct Options {
    std::string name = "telepalp-server";
    std::string bind = "127.0.0.1";
    std::uint16_t port = 0;  ///< 0: any free port
    std::string software{};  ///< name, version and commit of the program, for /server/stats; empty: not stated
    std::shared_ptr<access::Access> access = access::Access::without_keys();
    pipeline::EncodeOptions encode{};
    std::function<void(const std::string&)> log{};  ///< log lines about peers and the camera's state
  };

  /// Opens the port. Messages are published only after start() or play(). Error: the port cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<Server>> listen(boost::asio::io_context& io, Options options);

  /// Starts to capture from `source`. `source_name` appears in messages. `on_end` is called once when the source ends.
  void start(std::unique_ptr<capture::CaptureSource> source, const std::string& source_name,
             std::function<void()> on_end);

  /// Plays a recorded session instead of capturing. While a station is connected, the recorded station's messages are
  /// withheld, so that viewers see one hand. `on_end` is called once when the session ends.
  void play(std::unique_ptr<playback::SessionPlayer> player, std::function<void()> on_end);
  /// The player; nullptr unless play() was called.
  [[nodiscard]] playback::SessionPlayer* player() noexcept { return player_.get(); }

  /// The simulated network that the played session crosses. Until a command impairs it, each message passes at once.
  [[nodiscard]] playback::SessionNetwork& network() noexcept { return network_; }

  /// Stops capturing, sends queued messages and a Goodbye with `reason`. io.run() then returns within 1 s.
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
  void publish(wire::Message message);
  void publish_played(wire::Message message);
  [[nodiscard]] std::uint64_t frames() const;  ///< captured or played
  void publish_every_second();
  void show_newcomers_the_picture();
  void publish_clock_and_stats();
  void give_memory_back();
  void choose_prediction();
  void log_state_changes(const wire::Message& status);
  void log(const std::string& text) const;

  boost::asio::io_context& io_;
  Options options_;
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  hub::Hub hub_;
  std::unique_ptr<hub::PeerListener> listener_;
  boost::asio::steady_timer second_;
  bool stopped_ = false;  // checked by timer handlers: a timer that has expired cannot be cancelled
  std::chrono::steady_clock::time_point last_depth_{};
  std::string last_state_;              // last logged state
  bool predicts_ = true;                // depth images may depend on each other
  std::size_t most_waiting_bytes_ = 0;  // peak of the hub's queues since memory was last released
  std::chrono::steady_clock::time_point started_{};
  std::unique_ptr<pipeline::CaptureThread> capture_;
  playback::SessionNetwork network_;                 // between player_ and the hub
  std::unique_ptr<playback::SessionPlayer> player_;  // instead of capture_
};

}  // namespace telepalp::server
