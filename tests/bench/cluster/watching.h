#pragma once

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proto/wire/client/client_link.h"

namespace telepalp::bench {

/// The messages that one viewer received.
struct Watched {
  using Clock = std::chrono::steady_clock;
  std::map<std::uint64_t, Clock::time_point> arrived;  ///< depth images, by number
  std::uint64_t bytes = 0;                             ///< of all camera topics
  std::uint64_t messages = 0;                          ///< of all camera topics
  std::string news;                                    ///< the newest change of its connection

  /// The longest time without a depth image in [`from`, `to`] [s].
  [[nodiscard]] double longest_gap_s(Clock::time_point from, Clock::time_point to) const;
};

/// Viewers of servers, all on the calling thread.
class Viewers {
 public:
  struct Options {
    std::string host = "127.0.0.1";
    std::shared_ptr<const keys::KeyFile> key{};  ///< null: the servers have no keys
  };
  Viewers() = default;
  explicit Viewers(Options options) : options_(std::move(options)) {}

  /// Adds `count` viewers of the server at `port`. Returns the first of them.
  const Watched& add(std::uint16_t port, std::size_t count = 1);
  void run_for(std::chrono::duration<double> time);
  /// Runs until each viewer has a depth image, for at most 15 s. False: a viewer has none.
  bool all_see();
  [[nodiscard]] boost::asio::io_context& io() noexcept { return io_; }  ///< for what else runs beside them
  [[nodiscard]] std::size_t count() const noexcept { return viewers_.size(); }
  /// Bytes that all viewers received.
  [[nodiscard]] std::uint64_t bytes() const;
  /// Messages that all viewers received.
  [[nodiscard]] std::uint64_t messages() const;

 private:
  struct Viewer {
    Watched watched;
    std::unique_ptr<wire::ClientLink> link;
  };
  Options options_{};
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keeps_running_{io_.get_executor()};
  std::vector<std::unique_ptr<Viewer>> viewers_;
};

}  // namespace telepalp::bench
