#include "haptic_station/surface/grid/node_sums.h"

#include "haptic_station/surface/snapshot/soft_object_weight.h"
#include "proto/words/vectorised.h"

// sum_nodes() takes most of the time of a haptic tick. A query has 26 sums, which fill seven registers of four doubles,
// so the loop keeps them there. Each lane adds its terms in the order of the nodes.

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;
using Lanes [[gnu::vector_size(32)]] = double;
using FloatLanes [[gnu::vector_size(16)]] = float;

[[gnu::always_inline]] inline void load(const float* from, Lanes& to) noexcept {
  const FloatLanes floats{from[0], from[1], from[2], from[3]};
  to = __builtin_convertvector(floats, Lanes);
}

// Not inlined, because it is rarely called: the loop over the nodes then keeps its registers.
[[gnu::noinline]] void add_gate(double by_distance, double plane, const Vector3d& normal, const Vector3d& offset,
                                GateSums& sums) noexcept {
  const Vector3d by_m = by_distance * normal;
  sums.any = true;
  sums.weight += by_m;
  sums.plane += plane * by_m;
  sums.normal += normal * by_m.transpose();
  sums.offset += offset * by_m.transpose();
}

[[gnu::always_inline]] inline void unpack(double weight, const Lanes& normal, const Lanes& offset_plane,
                                          WeightedSums& sums) noexcept {
  sums.weight = weight;
  sums.plane = offset_plane[3];
  sums.normal = {normal[0], normal[1], normal[2]};
  sums.offset = {offset_plane[0], offset_plane[1], offset_plane[2]};
}

}  // namespace

TELEPALP_VECTORISED
void sum_nodes(const GridLayout& layout, const GridNode* nodes, const NodeWindow& window, double column, double row,
               const Vector3d& local, const MotionBasis* basis, NodeSums& sums) noexcept {
  const Lanes query{local.x(), local.y(), local.z(), 0.0};
  const double per_r2 = 1.0 / (layout.support_nodes * layout.support_nodes);
  const double per_gate2 = 1.0 / (layout.gate_m * layout.gate_m);
  FloatLanes terms[kMotionTerms]{};  // value and rate of each
  if (basis != nullptr)
    for (std::size_t term = 0; term < kMotionTerms; ++term)
      terms[term] = FloatLanes{basis->value[term], basis->rate[term], 0.0F, 0.0F};
  Lanes weights{};  // w, its derivatives by column and row, and w times velocity
  Lanes normal{}, normal_u{}, normal_v{};
  Lanes offset{}, offset_u{}, offset_v{};
  for (int v = window.first_row; v <= window.last_row; ++v) {
    const double dv = v - row;
    const GridNode* const start = nodes + static_cast<std::ptrdiff_t>(v) * layout.columns;
    for (int u = window.first_column; u <= window.last_column; ++u) {
      const double du = u - column;
      const Weight fade = soft_object_weight((du * du + dv * dv) * per_r2);
      const GridNode& node = start[u];
      if (fade.value <= 0.0 || !(node.confidence > 0.0F)) continue;
      FloatLanes motion{};
      if (basis != nullptr)
        for (std::size_t term = 0; term < kMotionTerms; ++term) motion += node.motion[term] * terms[term];
      const auto rise = static_cast<double>(motion[0]);
      Lanes at;
      Lanes n;  // and the deviation
      load(node.at_m.data(), at);
      load(node.normal.data(), n);
      Lanes o = query - at - rise * n;
      const Lanes products = n * o;
      const double plane = products[0] + products[1] + products[2];
      o[3] = plane;
      const Weight gate = flat_top_weight(plane * plane * per_gate2);
      if (gate.value <= 0.0) continue;
      const auto confidence = static_cast<double>(node.confidence);
      const double present = confidence * gate.value;
      const double w = present * fade.value;
      const double slope = -2.0 * per_r2 * present * fade.slope;  // the offset is node minus point
      const double wu = slope * du;
      const double wv = slope * dv;
      weights += Lanes{w, wu, wv, w * static_cast<double>(motion[1])};
      normal += w * n;
      normal_u += wu * n;
      normal_v += wv * n;
      offset += w * o;
      offset_u += wu * o;
      offset_v += wv * o;
      if (gate.slope != 0.0)
        add_gate(confidence * fade.value * gate.slope * 2.0 * plane * per_gate2, plane, {n[0], n[1], n[2]},
                 {o[0], o[1], o[2]}, sums.gate);
    }
  }
  unpack(weights[0], normal, offset, sums.value);
  unpack(weights[1], normal_u, offset_u, sums.by_column);
  unpack(weights[2], normal_v, offset_v, sums.by_row);
  sums.velocity = weights[3];
  sums.deviation = normal[3];
}

}  // namespace telepalp::surface
