#pragma once

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "proto/wire/client/client_link.h"

namespace telepalp::bench {

/// The messages that one viewer received.
struct Watched {
  using Clock = std::chrono::steady_clock;
  std::map<std::uint64_t, Clock::time_point> arrived;  ///< depth images, by number
  std::uint64_t bytes = 0;                             ///< of all camera topics

  /// The longest time without a depth image in [`from`, `to`] [s].
  [[nodiscard]] double longest_gap_s(Clock::time_point from, Clock::time_point to) const;
};

/// Viewers of servers on this machine, all on the calling thread.
class Viewers {
 public:
  /// Adds `count` viewers of the server at `port`. Returns the first of them.
  const Watched& add(std::uint16_t port, std::size_t count = 1);
  void run_for(std::chrono::duration<double> time);
  /// Runs until each viewer has a depth image, for at most 15 s. False: a viewer has none.
  bool all_see();
  /// Bytes that all viewers received.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct Viewer {
    Watched watched;
    std::unique_ptr<wire::ClientLink> link;
  };
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> keeps_running_{io_.get_executor()};
  std::vector<std::unique_ptr<Viewer>> viewers_;
};

}  // namespace telepalp::bench
