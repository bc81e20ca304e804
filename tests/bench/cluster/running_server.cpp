#include "tests/bench/cluster/running_server.h"

#include <optional>
#include <utility>

#include "where.h"

namespace telepalp::bench {

Result<RunningServer> start_server(const std::filesystem::path& scratch, const std::string& name,
                                   std::vector<std::string> options) {
  const std::filesystem::path ready = scratch / (name + ".ready");
  std::filesystem::remove(ready);
  for (const std::string& more : {std::string("--port"), std::string("0"), std::string("--ready-file"), ready.string()})
    options.push_back(more);
  RunningServer server{.process = std::make_unique<support::ChildProcess>(TELEPALP_BINARY_DIR "/bin/telepalp-server",
                                                                          options, scratch / (name + ".log"))};
  const std::optional<std::string> port = support::await_ready(ready, "port");
  if (!port)
    return Error{.what = "telepalp-server does not start",
                 .where = (scratch / (name + ".log")).string(),
                 .fix = "read this file"};
  server.port = static_cast<std::uint16_t>(std::stoi(*port));
  return server;
}

Result<ServerPair> start_pair(const std::filesystem::path& scratch, const std::string& of_site,
                              const std::string& of_edge) {
  Result<RunningServer> site =
      start_server(scratch, "site", {"--source", "synthetic", "--publish", of_site + "/bench"});
  if (!site) return site.error();
  Result<RunningServer> edge = start_server(scratch, "edge", {"--source", of_edge + "/bench"});
  if (!edge) return edge.error();
  return ServerPair{.site = *std::move(site), .edge = *std::move(edge)};
}

Error sees_nothing() {
  return {.what = "a viewer got no image",
          .where = "telepalp-bench cluster",
          .fix = "run telepalp-server and telepalp-view by hand"};
}

}  // namespace telepalp::bench
