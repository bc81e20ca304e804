#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {

/// True as soon as the nats-server that writes `log` is ready; false: not within `patience`.
[[nodiscard]] bool nats_is_ready(const std::filesystem::path& log, std::chrono::seconds patience);

/// A cluster of real NATS servers on loopback. They end with this object.
class NatsCluster {
 public:
  enum class Stores { Nothing, Files };  ///< Files: each node has JetStream, and stores streams in `scratch`
  /// Error: nats-server is not installed, or does not start.
  [[nodiscard]] static Result<NatsCluster> start(std::size_t nodes, const std::filesystem::path& scratch,
                                                 Stores stores = Stores::Nothing);

  /// The address of one node: nats://HOST:PORT.
  [[nodiscard]] std::string url(std::size_t node) const;
  /// The addresses of all nodes, from `first` on, separated by commas.
  [[nodiscard]] std::string urls_from(std::size_t first) const;
  [[nodiscard]] support::ChildProcess& node(std::size_t number) { return *nodes_[number]; }

 private:
  std::vector<std::unique_ptr<support::ChildProcess>> nodes_;
  std::vector<std::string> ports_;
};

}  // namespace telepalp::bench
