#include "haptic_station/surface/grid/grid_snapshot.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/grid/node_cover.h"
#include "haptic_station/surface/grid/node_fit.h"

namespace telepalp::surface {
namespace {

/// Floats are accurate to 0.1 µm within two metres of their origin, so the grid's origin lies near its points.
Eigen::Vector3d origin_for(const std::optional<Reach>& reach) {
  return reach && reach->centre.m.allFinite() ? reach->centre.m : Eigen::Vector3d(0.0, 0.0, 1.0);
}

}  // namespace

GridSnapshot::GridSnapshot(const DepthField& depth, const Intrinsics& camera, const std::optional<Reach>& reach,
                           const SurfaceSettings& settings) {
  layout_.origin_m = origin_for(reach);
  layout_.support_nodes = settings.support_nodes;
  layout_.gate_m = settings.gate_m;
  const int margin = settings.node_step_px * (1 + static_cast<int>(std::ceil(settings.support_nodes)));
  fit_nodes(depth, camera, box_in_reach(camera, reach, margin),
            {settings.node_step_px, settings.fit_radius_px, settings.break_m, settings.bridge_px}, layout_, storage_);
  nodes_ = storage_;
  points = static_cast<std::uint32_t>(
      std::count_if(storage_.begin(), storage_.end(), [](const GridNode& node) { return node.confidence > 0.0F; }));
  index_name = "depth lattice";
}

namespace {

/// The terms of the field on one row of the image, as spline coefficients along the row.
void blend_down(const MotionField& field, double v, std::vector<MotionTerms>& across) {
  const CellLattice& lattice = field.lattice();
  const Knots down = knots_at(v, lattice.rows);
  for (int column = 0; column < lattice.columns; ++column) {
    MotionTerms& sum = across[static_cast<std::size_t>(column)];
    sum = {};
    for (std::size_t k = 0; k < 4; ++k) {
      const MotionTerms& terms = field.terms()[lattice.at(column, down.cell[k])];
      for (std::size_t term = 0; term < terms.size(); ++term) sum[term] += down.share[k] * terms[term];
    }
  }
}

}  // namespace

void GridSnapshot::carry_forward(const MotionField& field) {
  motion = field.model();
  std::vector<Knots> knots;
  for (int column = 0; column < layout_.columns; ++column)
    knots.push_back(knots_at(layout_.left_px + column * layout_.step_px, field.lattice().columns));
  std::vector<MotionTerms> across(static_cast<std::size_t>(field.lattice().columns));
  for (int row = 0; row < layout_.rows; ++row) {
    const double v = layout_.top_px + row * layout_.step_px;
    blend_down(field, v, across);
    const auto y = static_cast<float>((v - layout_.camera.cy) / layout_.camera.fy);
    for (int column = 0; column < layout_.columns; ++column) {
      GridNode& node = storage_[static_cast<std::size_t>(row * layout_.columns + column)];
      if (node.confidence <= 0.0F) continue;
      const auto x =
          static_cast<float>((layout_.left_px + column * layout_.step_px - layout_.camera.cx) / layout_.camera.fx);
      const float along_normal = node.normal[0] * x + node.normal[1] * y + node.normal[2];
      const Knots& at = knots[static_cast<std::size_t>(column)];
      MotionTerms sum{};
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t term = 0; term < sum.size(); ++term)
          sum[term] += at.share[k] * along_normal * across[static_cast<std::size_t>(at.cell[k])][term];
      node.motion = sum;
    }
  }
}

void GridSnapshot::fade(const BlockLattice& lattice, std::span<const float> shown) {
  // A lattice of nodes without holes, with a slightly greater weight than kWholeCover, has the coverage 1 everywhere.
  constexpr auto kLeast = static_cast<float>(kLeastCover);
  constexpr auto kWhole = static_cast<float>(1.1 * kWholeCover);
  for (int row = 0; row < layout_.rows; ++row)
    for (int column = 0; column < layout_.columns; ++column) {
      const int u = static_cast<int>(layout_.left_px + column * layout_.step_px) / BlockLattice::kBlock_px;
      const int v = static_cast<int>(layout_.top_px + row * layout_.step_px) / BlockLattice::kBlock_px;
      const float share = shown[lattice.at(u, v)];
      if (share >= 1.0F) continue;
      GridNode& node = storage_[static_cast<std::size_t>(row * layout_.columns + column)];
      node.confidence = share <= 0.0F ? 0.0F : std::min(node.confidence, kLeast + share * (kWhole - kLeast));
    }
}

}  // namespace telepalp::surface
