#include "tools/edge_plan/edges_text.h"

#include <cstdio>

#include "proto/words/counted.h"

namespace telepalp::edge_plan {
namespace {

using EdgeBound = EdgePlan::EdgeBound;
using ComputerBound = EdgePlan::ComputerBound;

std::string with(const char* format, auto... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// "29.3 Mbit/s" or "293 Gbit/s".
std::string rate(double Mbit_per_s) {
  return Mbit_per_s < 1000.0 ? with("%.1f Mbit/s", Mbit_per_s) : with("%.1f Gbit/s", 1e-3 * Mbit_per_s);
}

std::string edge_line(const Asked& asked, const EdgeCosts& costs, const EdgePlan& plan) {
  const auto viewers = static_cast<double>(plan.viewers_per_edge);
  return counted(plan.viewers_per_edge, "viewer", "viewers") + " at most, " +
         (plan.edge_bound == EdgeBound::Places ? "which are all of its places"
                                               : with("with %.0f %% of one core", 100.0 * asked.limits.core_share)) +
         with(": %.2f cores, %s, %.0f MiB, %.0f descriptors", costs.cores_of(asked.stream, viewers),
              rate(viewers * asked.stream.Mbit_per_s()).c_str(), costs.idle_MiB + viewers * costs.viewer_MiB,
              costs.idle_descriptors + viewers * costs.viewer_descriptors);
}

std::string bound_words(const Asked& asked, const EdgePlan& plan) {
  switch (plan.computer_bound) {
    case ComputerBound::Network:
      return with("%.0f %% of its network of %s", 100.0 * asked.limits.network_share,
                  rate(asked.computer.Mbit_per_s).c_str());
    case ComputerBound::Cores:
      return with("%.0f %% of its %g cores", 100.0 * asked.limits.core_share, asked.computer.cores);
    case ComputerBound::Places:
      break;
  }
  return "the places of all of its edges";
}

std::string cluster_line(const Asked& asked, const EdgePlan& plan) {
  const std::string sends = rate(plan.to_edges_Mbit_per_s) + " to the edges, " + with("%.1f cores", plan.nats_cores);
  if (plan.nats_servers == 1) return "1 NATS server on such a computer sends " + sends;
  if (plan.nats_servers > 1)
    return with("%zu NATS servers on such computers (1 for the site, %zu for the edges) send ", plan.nats_servers,
                plan.nats_servers - 1) +
           sends;
  return "one cluster of NATS servers with a network of " + rate(asked.computer.Mbit_per_s) + " cannot send " + sends;
}

std::string what_helps(const EdgePlan& plan) {
  if (plan.nats_servers == 0)
    return "so: the NATS cluster is the bottleneck. A faster --network helps, or fewer bytes for each viewer";
  switch (plan.computer_bound) {
    case ComputerBound::Network:
      return "so: the network is the bottleneck. A faster --network helps, or fewer bytes for each viewer";
    case ComputerBound::Cores:
      return "so: the cores are the bottleneck. More or faster --cores help, or fewer bytes for each viewer";
    case ComputerBound::Places:
      break;
  }
  return "so: the number of edges on a computer is the bottleneck. More computers help";
}

}  // namespace

std::string in_lines(const Asked& asked, const EdgeCosts& edge, const EdgePlan& plan) {
  return counted(asked.viewers, "viewer", "viewers") + with(", %s each\n", rate(asked.stream.Mbit_per_s()).c_str()) +
         "an edge      " + edge_line(asked, edge, plan) + "\n" + "a computer   " +
         counted(plan.viewers_per_computer, "viewer", "viewers") + " at most, with " + bound_words(asked, plan) + "\n" +
         "in all       " + counted(plan.computers, "computer", "computers") + " with " +
         counted(plan.edges_per_computer, "edge", "edges") + " each: " +
         with("%.1f cores of edges, %s to viewers\n", plan.edge_cores, rate(plan.to_viewers_Mbit_per_s).c_str()) +
         "the cluster  " + cluster_line(asked, plan) + "\n" + "the site     sends " + rate(asked.stream.Mbit_per_s()) +
         ", whatever the number of viewers\n" + what_helps(plan) + "\n";
}

}  // namespace telepalp::edge_plan
