#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {

/// A telepalp-server that is ready, and listens on loopback. It ends with this object.
struct RunningServer {
  std::unique_ptr<support::ChildProcess> process;
  std::uint16_t port = 0;
};

/// Starts a server whose log is NAME.log in `scratch`. Error: it does not start; the error names the log.
[[nodiscard]] Result<RunningServer> start_server(const std::filesystem::path& scratch, const std::string& name,
                                                 std::vector<std::string> options);

/// A site with a synthetic patient that publishes to a cluster, and an edge of it.
struct ServerPair {
  RunningServer site, edge;
};
/// `of_site`, `of_edge`: the addresses of the nodes to which each connects, the first one first.
[[nodiscard]] Result<ServerPair> start_pair(const std::filesystem::path& scratch, const std::string& of_site,
                                            const std::string& of_edge);

/// No image came to a viewer.
[[nodiscard]] Error sees_nothing();

}  // namespace telepalp::bench
