#include "tests/bench/cluster/nats_cluster.h"

#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <fstream>
#include <thread>

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using boost::asio::ip::tcp;

constexpr const char* kServer = "/usr/sbin/nats-server";  // of Debian's package

/// A port that no program listens on at the moment of the call.
std::string free_port() {
  boost::asio::io_context io;
  return std::to_string(tcp::acceptor(io, tcp::endpoint(tcp::v4(), 0)).local_endpoint().port());
}

/// Waits for at most 10 s until the server writes to its log that it is ready.
}  // namespace

bool nats_is_ready(const std::filesystem::path& log, std::chrono::seconds patience) {
  for (const auto end = std::chrono::steady_clock::now() + patience; std::chrono::steady_clock::now() < end;
       std::this_thread::sleep_for(50ms)) {
    std::ifstream file(log);
    for (std::string line; std::getline(file, line);)
      if (line.find("Server is ready") != std::string::npos) return true;
  }
  return false;
}

Result<NatsCluster> NatsCluster::start(std::size_t nodes, const std::filesystem::path& scratch, Stores stores) {
  if (::access(kServer, X_OK) != 0)
    return Error{.what = "nats-server is not installed",
                 .where = "telepalp-bench cluster",
                 .fix = "run deploy/install services"};
  NatsCluster cluster;
  std::vector<std::string> among;  // ports on which the nodes reach each other
  for (std::size_t i = 0; i < nodes; ++i) {
    cluster.ports_.push_back(free_port());
    among.push_back(free_port());
  }
  std::string routes;
  for (const std::string& port : among) routes += (routes.empty() ? "" : ",") + ("nats://127.0.0.1:" + port);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::filesystem::path log = scratch / ("node" + std::to_string(i) + ".log");
    std::vector<std::string> arguments{"-a", "127.0.0.1", "-p", cluster.ports_[i], "-n", "node" + std::to_string(i)};
    if (stores == Stores::Files)
      arguments.insert(arguments.end(), {"-js", "-sd", scratch / ("store" + std::to_string(i))});
    if (nodes > 1)
      for (const std::string& more : {std::string("--cluster_name"), std::string("bench"), std::string("--cluster"),
                                      "nats://127.0.0.1:" + among[i], std::string("--routes"), routes})
        arguments.push_back(more);
    cluster.nodes_.push_back(std::make_unique<support::ChildProcess>(kServer, arguments, log));
    if (!nats_is_ready(log, 10s))
      return Error{.what = "nats-server does not start", .where = log.string(), .fix = "read this file"};
  }
  std::this_thread::sleep_for(1s);  // until the nodes have found each other
  return cluster;
}

std::string NatsCluster::url(std::size_t node) const { return "nats://127.0.0.1:" + ports_[node]; }

std::string NatsCluster::urls_from(std::size_t first) const {
  std::string urls;
  for (std::size_t i = 0; i < ports_.size(); ++i) urls += (i > 0 ? "," : "") + url((first + i) % ports_.size());
  return urls;
}

}  // namespace telepalp::bench
