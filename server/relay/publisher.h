#pragma once

#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/hub/hub.h"
#include "server/relay/relay_address.h"
#include "support/nats/nats_connection.h"

namespace telepalp::relay {

/// Publishes what a hub distributes (is_relayed()) to a cluster, for edges. A thread of its own writes to the cluster,
/// so that a slow cluster delays no peer; of what the thread cannot take, the hub drops the oldest, topic by topic.
/// Answers edges that ask for the time, or for the latched messages and a key frame. Owner: the server's network
/// thread.
class Publisher {
 public:
  struct Options {
    RelayAddress address;
    std::function<void(const std::string&)> log = [](const std::string&) {};
  };
  struct Counts {
    std::uint64_t published = 0;  ///< messages written to the cluster
    std::uint64_t lost = 0;       ///< messages that the thread had taken while there was no connection
  };

  /// Error: the cluster cannot be reached, or another server publishes the same site.
  [[nodiscard]] static Result<std::unique_ptr<Publisher>> open(boost::asio::io_context& io, hub::Hub& hub,
                                                               const wire::SessionClock& clock, Options options);
  ~Publisher();
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  [[nodiscard]] Counts counts() const noexcept;

 private:
  class Line;
  explicit Publisher(std::shared_ptr<Line> line);
  std::shared_ptr<Line> line_;  // shared with what waits in the io_context
};

}  // namespace telepalp::relay
