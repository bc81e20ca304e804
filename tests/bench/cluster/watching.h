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

/// Depth images as one viewer got them.
struct Watched {
  using Clock = std::chrono::steady_clock;
  std::map<std::uint64_t, Clock::time_point> arrived;  ///< by the image's number
  std::uint64_t bytes = 0;                             ///< of all topics

  /// The longest time without an image in [`from`, `to`] [s].
  [[nodiscard]] double longest_gap_s(Clock::time_point from, Clock::time_point to) const;
};

/// Viewers of the ports of servers on this machine, on one thread.
class Viewers {
 public:
  /// `count` viewers of the server at `port`; the returned one is the first of them.
  const Watched& add(std::uint16_t port, std::size_t count = 1);
  void run_for(std::chrono::duration<double> time);
  /// True once each viewer has an image; waits for at most 15 s.
  bool all_see();
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
