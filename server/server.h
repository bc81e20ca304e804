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

namespace telepalp::server {

/// The whole server but its command line: a source, the hub, and the listener. Lives on `io`'s one thread, which
/// is the network thread; the capture thread is its own.
class Server {
 public:
  struct Options {
    std::string name = "telepalp-server";
    std::string bind = "127.0.0.1";
    std::uint16_t port = 0;  ///< 0: any free one
    EncodeOptions encode{};
    std::function<void(const std::string&)> log{};  ///< for the technician: who comes and goes, what the camera does
  };

  /// Listens; nothing is published before start().
  [[nodiscard]] static Result<std::unique_ptr<Server>> listen(boost::asio::io_context& io, Options options);

  /// Captures from `source`, called `source_name`. `on_end` is called once when the source has come to its end.
  void start(std::unique_ptr<CaptureSource> source, const std::string& source_name, std::function<void()> on_end);

  /// Captures no more, sends what is queued, says Goodbye with `reason`. io.run() then returns within a second.
  void stop(const std::string& reason);

  [[nodiscard]] std::uint16_t port() const noexcept { return listener_->port(); }
  [[nodiscard]] const wire::SessionClock& clock() const noexcept { return clock_; }
  [[nodiscard]] Hub& hub() noexcept { return hub_; }
  /// One line about what was done, for the end.
  [[nodiscard]] std::string summary() const;

 private:
  Server(boost::asio::io_context& io, Options options);
  void publish(wire::Message message);
  void publish_every_second();
  void publish_clock_and_stats();
  void give_memory_back();
  void log_state_changes(const wire::Message& status);
  void log(const std::string& text) const;

  boost::asio::io_context& io_;
  Options options_;
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  Hub hub_;
  std::unique_ptr<PeerListener> listener_;
  boost::asio::steady_timer second_;
  bool stopped_ = false;                // a timer that has fired cannot be cancelled: its handler looks here
  std::string last_state_;              // as last logged
  std::size_t most_waiting_bytes_ = 0;  // in the hub, since memory was last given back
  std::chrono::steady_clock::time_point started_{};
  std::unique_ptr<CaptureThread> capture_;
};

}  // namespace telepalp::server
