#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::edge_plan {

/// What one viewer gets.
struct Stream {
  double bytes_per_s = 0.0;
  double messages_per_s = 0.0;
  [[nodiscard]] constexpr double Mbit_per_s() const noexcept { return 8e-6 * bytes_per_s; }
};

/// What an edge with keys uses. `telepalp-bench cluster --part model` measures these figures.
struct EdgeCosts {
  double idle_cores = 0.0;         ///< an edge of a site that sends nothing
  double s_per_byte_in = 0.0;      ///< processor time of a byte from the cluster
  double s_per_message_out = 0.0;  ///< processor time of a message to a viewer, whatever its size
  double s_per_byte_out = 0.0;     ///< processor time of a byte to a viewer
  double idle_MiB = 0.0;           ///< memory without viewers
  double viewer_MiB = 0.0;
  double idle_descriptors = 0.0;  ///< files and sockets without viewers
  double viewer_descriptors = 0.0;

  /// Cores that an edge uses while it sends `messages` and `bytes` each second, to all of its viewers together.
  [[nodiscard]] constexpr double cores(double bytes_in, double messages, double bytes) const noexcept {
    return idle_cores + s_per_byte_in * bytes_in + s_per_message_out * messages + s_per_byte_out * bytes;
  }
  [[nodiscard]] constexpr double cores_of(const Stream& stream, double viewers) const noexcept {
    return cores(stream.bytes_per_s, viewers * stream.messages_per_s, viewers * stream.bytes_per_s);
  }
};

/// What the NATS servers between site and edges use.
struct ClusterCosts {
  double s_per_byte_in = 0.0;   ///< processor time of a byte from the site
  double s_per_byte_out = 0.0;  ///< processor time of a byte to one edge
};

/// One of the computers that run edges, or a NATS server.
struct Computer {
  double cores = 4.0;
  double Mbit_per_s = 1000.0;  ///< of its network, in each direction
};

/// How much of a computer may be used, so that a burst still finds room.
struct Limits {
  std::size_t places = 48;  ///< viewers that one edge takes (hub::PlaceLimits)
  double core_share = 0.7;  ///< also of the one core that sends an edge's messages
  double network_share = 0.8;
};

struct Asked {
  std::size_t viewers = 10'000;
  Stream stream{};
  Computer computer{};
  Limits limits{};
};

/// Edges for a number of viewers.
struct EdgePlan {
  enum class EdgeBound { Places, Core };                ///< why an edge serves no more viewers
  enum class ComputerBound { Places, Cores, Network };  ///< why a computer serves no more viewers

  std::size_t viewers_per_edge = 0;  ///< at most
  EdgeBound edge_bound = EdgeBound::Places;
  std::size_t viewers_per_computer = 0;  ///< at most
  ComputerBound computer_bound = ComputerBound::Network;
  std::size_t computers = 0;
  std::size_t edges_per_computer = 0;
  std::size_t edges = 0;
  std::size_t nats_servers = 0;  ///< 0: more than one layer of NATS servers is needed
  double edge_cores = 0.0;       ///< of all edges, when all viewers watch
  double nats_cores = 0.0;
  double to_viewers_Mbit_per_s = 0.0;
  double to_edges_Mbit_per_s = 0.0;
};

/// Error: a computer or an edge is too small for one viewer.
[[nodiscard]] Result<EdgePlan> plan_edges(const Asked& asked, const EdgeCosts& edge, const ClusterCosts& cluster);

/// What a viewer gets of the synthetic patient: depth of 640x480 and colour as JPEG, 30 images a second of each.
struct Content {
  std::string_view depth_mode;  ///< telepalp-server --depth-mode
  Stream stream{};
};
inline constexpr std::array kContents{
    Content{"fast", {3.69e6, 60.0}},
    Content{"intra", {3.49e6, 60.0}},
    Content{"temporal", {3.50e6, 60.0}},
    Content{"bounded", {1.99e6, 60.0}},
};

/// Measured on an Intel Xeon at 2.5 GHz over loopback, with TLS (docs/operations.md).
inline constexpr EdgeCosts kMeasuredEdge{.idle_cores = 0.0054,
                                         .s_per_byte_in = 2.84e-9,
                                         .s_per_message_out = 41.5e-6,
                                         .s_per_byte_out = 0.67e-9,
                                         .idle_MiB = 17.5,
                                         .viewer_MiB = 0.17,
                                         .idle_descriptors = 13.0,
                                         .viewer_descriptors = 1.0};
inline constexpr ClusterCosts kMeasuredCluster{.s_per_byte_in = 4.1e-9, .s_per_byte_out = 2.9e-9};

}  // namespace telepalp::edge_plan
