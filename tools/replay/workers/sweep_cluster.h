#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "support/nats/streams.h"

namespace telepalp::replay {

/// The version and commit of this program, on which all of its results depend: "telepalp 0.2.0, commit 1a2b3c4d".
[[nodiscard]] std::string this_build();

/// The cluster in which sweeps and workers meet.
struct SweepCluster {
  std::unique_ptr<nats::NatsConnection> connection;
  std::unique_ptr<nats::Streams> streams;

  /// Connects, and makes the streams of sweeps unless the cluster has them. `program_name` logs when the connection is
  /// lost and found. `client`: a name for the NATS server's monitoring. `on_return`: called when a lost connection is
  /// there again, on a thread of the library. Error: the cluster cannot be reached, has no JetStream, or JetStream is
  /// full.
  [[nodiscard]] static Result<SweepCluster> join(const nats::Address& address, std::string_view program_name,
                                                 const std::string& client, std::function<void()> on_return = {});
};

}  // namespace telepalp::replay
