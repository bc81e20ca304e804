#include "tools/edge_plan/edge_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace telepalp::edge_plan {
namespace {

using EdgeBound = EdgePlan::EdgeBound;
using ComputerBound = EdgePlan::ComputerBound;

constexpr std::size_t kMostEdgesOfAComputer = 256;

std::size_t whole(double count) {
  constexpr double kMost = 1e9;
  return static_cast<std::size_t>(std::clamp(std::floor(count + 1e-9), 0.0, kMost));
}

std::size_t ceil_of(std::size_t all, std::size_t each) { return (all + each - 1) / each; }

/// Cores of one more viewer.
double viewer_cores(const EdgeCosts& costs, const Stream& stream) {
  return costs.cores_of(stream, 1.0) - costs.cores_of(stream, 0.0);
}

/// Viewers for whom `cores` are enough, on `edges` edges.
std::size_t viewers_of_cores(double cores, std::size_t edges, const EdgeCosts& costs, const Stream& stream) {
  const double each = viewer_cores(costs, stream);
  const double left = cores - static_cast<double>(edges) * costs.cores_of(stream, 0.0);
  if (left < 0.0) return 0;
  return each > 0.0 ? whole(left / each) : std::numeric_limits<std::size_t>::max();
}

/// What a computer with a number of edges carries.
struct Carried {
  std::size_t viewers = 0;
  ComputerBound bound = ComputerBound::Places;
};

Carried carried(const Asked& asked, const EdgeCosts& costs, std::size_t edges, std::size_t viewers_per_edge) {
  const double streams = asked.limits.network_share * asked.computer.Mbit_per_s / asked.stream.Mbit_per_s();
  Carried most{edges * viewers_per_edge, ComputerBound::Places};
  const std::size_t by_network = whole(streams) >= edges ? whole(streams) : 0;  // each edge takes the stream, too
  if (by_network < most.viewers) most = {by_network, ComputerBound::Network};
  const std::size_t by_cores =
      viewers_of_cores(asked.limits.core_share * asked.computer.cores, edges, costs, asked.stream);
  if (by_cores < most.viewers) most = {by_cores, ComputerBound::Cores};
  return most;
}

/// The NATS servers: one, or one that the site uses and others that send to the edges. 0: not enough.
std::size_t nats_servers_for(std::size_t edges, const Asked& asked, const ClusterCosts& costs) {
  const double B_per_s = asked.stream.bytes_per_s;
  const double by_network = asked.limits.network_share * asked.computer.Mbit_per_s / asked.stream.Mbit_per_s();
  const double cores = asked.limits.core_share * asked.computer.cores - costs.s_per_byte_in * B_per_s;
  const double by_cores = costs.s_per_byte_out > 0.0 ? cores / (costs.s_per_byte_out * B_per_s) : by_network;
  const std::size_t each = whole(std::min(by_network, by_cores));
  if (each == 0) return 0;
  if (edges <= each) return 1;
  const std::size_t more = ceil_of(edges, each);
  return more <= each ? 1 + more : 0;
}

Error too_small(const char* what) {
  return {.what = std::string(what) + " is too small for one viewer",
          .where = "telepalp-link edges",
          .fix = "give --cores and --network of larger computers, or a --content that is smaller"};
}

/// Chooses how many edges run on a computer, and how many computers there are.
Result<void> add_computers(EdgePlan& plan, const Asked& asked, const EdgeCosts& edge) {
  Carried most;
  for (std::size_t edges = 1; edges <= kMostEdgesOfAComputer; ++edges)
    if (const Carried here = carried(asked, edge, edges, plan.viewers_per_edge); here.viewers > most.viewers)
      most = here;
  if (most.viewers == 0) return too_small("a computer");
  plan.viewers_per_computer = most.viewers;
  plan.computer_bound =
      carried(asked, edge, ceil_of(most.viewers, plan.viewers_per_edge) + 1, plan.viewers_per_edge).bound;
  plan.computers = ceil_of(asked.viewers, most.viewers);
  const std::size_t each = ceil_of(asked.viewers, plan.computers);
  while (carried(asked, edge, ++plan.edges_per_computer, plan.viewers_per_edge).viewers < each) continue;
  plan.edges = std::min(plan.computers * plan.edges_per_computer, asked.viewers);
  return {};
}

}  // namespace

Result<EdgePlan> plan_edges(const Asked& asked, const EdgeCosts& edge, const ClusterCosts& cluster) {
  EdgePlan plan;
  const std::size_t by_core = viewers_of_cores(asked.limits.core_share, 1, edge, asked.stream);
  plan.edge_bound = by_core < asked.limits.places ? EdgeBound::Core : EdgeBound::Places;
  plan.viewers_per_edge = std::min(by_core, asked.limits.places);
  if (plan.viewers_per_edge == 0) return too_small("an edge");
  if (const Result<void> added = add_computers(plan, asked, edge); !added) return added.error();
  const double viewers = static_cast<double>(asked.viewers), edges = static_cast<double>(plan.edges);
  plan.edge_cores = edges * edge.cores_of(asked.stream, 0.0) + viewers * viewer_cores(edge, asked.stream);
  plan.to_viewers_Mbit_per_s = viewers * asked.stream.Mbit_per_s();
  plan.to_edges_Mbit_per_s = edges * asked.stream.Mbit_per_s();
  plan.nats_servers = nats_servers_for(plan.edges, asked, cluster);
  const double servers = static_cast<double>(std::max<std::size_t>(plan.nats_servers, 1));
  plan.nats_cores =
      asked.stream.bytes_per_s * (servers * cluster.s_per_byte_in + (edges + servers - 1.0) * cluster.s_per_byte_out);
  return plan;
}

}  // namespace telepalp::edge_plan
