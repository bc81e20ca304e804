#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>

#include "proto/impaired/impairment.h"
#include "proto/words/result.h"
#include "support/program/address.h"

namespace telepalp::link_proxy {

struct ProxyOptions {
  program::Address listen;  ///< port 0: any free port, the same for UDP and TCP
  program::Address server;
  impaired::Impairment down;
  impaired::Impairment up;
  impaired::Trace trace;  ///< trace for both directions; empty: none
  std::uint64_t seed = 1;
};

/// A proxy for UDP and TCP between clients and one server; both protocols share one impaired link each way. Owner: the
/// thread that runs `io`.
class LinkProxy {
 public:
  [[nodiscard]] static Result<std::unique_ptr<LinkProxy>> start(boost::asio::io_context& io,
                                                                const ProxyOptions& options);
  ~LinkProxy();

  [[nodiscard]] std::uint16_t port() const;
  /// One line with the traffic since the last call and the bytes in the queues of the bottlenecks.
  [[nodiscard]] std::string live_line();
  /// Counters since the start, as JSON.
  [[nodiscard]] std::string totals_json() const;
  void stop();

 private:
  struct Parts;
  explicit LinkProxy(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::link_proxy
