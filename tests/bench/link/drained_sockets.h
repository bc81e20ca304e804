#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <deque>
#include <string>
#include <thread>
#include <vector>

namespace telepalp::bench {

/// Subscribers' sockets. A thread counts the bytes that arrive on each, and discards them without a copy.
class DrainedSockets {
 public:
  /// Connects `count` sockets to `port` of this machine and sends `first_words` on each.
  DrainedSockets(std::uint16_t port, std::size_t count, const std::string& first_words);
  ~DrainedSockets();
  DrainedSockets(const DrainedSockets&) = delete;
  DrainedSockets& operator=(const DrainedSockets&) = delete;

  /// Number of bytes received by each socket so far.
  [[nodiscard]] std::vector<std::uint64_t> bytes() const;

 private:
  void drain();

  boost::asio::io_context io_;
  std::vector<boost::asio::ip::tcp::socket> sockets_;
  std::deque<std::atomic<std::uint64_t>> bytes_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace telepalp::bench
