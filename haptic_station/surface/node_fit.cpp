#include "haptic_station/surface/node_fit.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/window_fit.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

/// Weights along one axis, (1 − (k/(r+1))²)², and their even moments: a separable window, smooth to its rim.
struct AxisWeights {
  std::vector<double> by_distance;
  double m0 = 0.0;
  double m2 = 0.0;
  double m4 = 0.0;
  double gain = 0.0;  ///< variance of the fitted centre over a pixel's
};

AxisWeights axis_weights(int radius) {
  AxisWeights axis;
  for (int k = 0; k <= radius; ++k) {
    const double t = static_cast<double>(k) / (radius + 1);
    axis.by_distance.push_back((1.0 - t * t) * (1.0 - t * t));
  }
  const auto weight = [&](int k) { return axis.by_distance[static_cast<std::size_t>(std::abs(k))]; };
  for (int k = -radius; k <= radius; ++k) {
    const double square = static_cast<double>(k) * k;
    axis.m0 += weight(k);
    axis.m2 += weight(k) * square;
    axis.m4 += weight(k) * square * square;
  }
  const double mean = axis.m2 / axis.m0;
  const double spread = axis.m4 - axis.m2 * mean;
  for (int l = -radius; l <= radius; ++l)
    for (int k = -radius; k <= radius; ++k) {
      const double bend = (k * k - mean + l * l - mean) * mean / (spread * axis.m0);
      const double tap = weight(k) * weight(l) * (1.0 / (axis.m0 * axis.m0) - bend);
      axis.gain += tap * tap;
    }
  return axis;
}

/// The box's pixels, grown by the fit's radius where the image allows, as inverse depth with breaks and the running
/// count of pixels that a fast window must not hold.
struct Crop {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<float> per_m;
  std::vector<std::uint8_t> breaks;
  std::vector<int> troubles;  ///< summed-area table, (width + 1) × (height + 1)

  [[nodiscard]] std::size_t at(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] int& troubles_at(int column, int row) noexcept {
    return troubles[static_cast<std::size_t>(row) * static_cast<std::size_t>(width + 1) +
                    static_cast<std::size_t>(column)];
  }
  [[nodiscard]] int trouble_in(int column, int row, int radius) noexcept {
    return troubles_at(column + radius + 1, row + radius + 1) - troubles_at(column - radius, row + radius + 1) -
           troubles_at(column + radius + 1, row - radius) + troubles_at(column - radius, row - radius);
  }
};

bool broken(float a, float b, float break_at_1m) noexcept {
  return a > 0.0F && b > 0.0F && std::abs(a - b) > break_at(std::min(a, b), break_at_1m);
}

Crop crop_of(const DepthField& depth, const PixelBox& box, const FitSettings& settings) {
  Crop crop;
  crop.left = std::max(0, box.left - settings.radius_px);
  crop.top = std::max(0, box.top - settings.radius_px);
  crop.width = std::min(depth.width, box.right + settings.radius_px) - crop.left;
  crop.height = std::min(depth.height, box.bottom + settings.radius_px) - crop.top;
  const std::size_t count = static_cast<std::size_t>(crop.width) * static_cast<std::size_t>(crop.height);
  crop.per_m.resize(count);
  crop.breaks.assign(count, 0);
  crop.troubles.assign(static_cast<std::size_t>(crop.width + 1) * static_cast<std::size_t>(crop.height + 1), 0);
  const auto limit = static_cast<float>(settings.break_m);
  for (int row = 0; row < crop.height; ++row) {
    int in_row = 0;
    for (int column = 0; column < crop.width; ++column) {
      const std::size_t from = depth.index(crop.left + column, crop.top + row);
      const float z = depth.z_m[from];
      const std::size_t to = crop.at(column, row);
      crop.per_m[to] = z > 0.0F ? 1.0F / z : 0.0F;
      if (column + 1 < crop.width && broken(z, depth.z_m[from + 1], limit)) crop.breaks[to] |= kBrokenRight;
      if (row + 1 < crop.height && broken(z, depth.z_m[from + static_cast<std::size_t>(depth.width)], limit))
        crop.breaks[to] |= kBrokenBelow;
      in_row += (z > 0.0F && crop.breaks[to] == 0) ? 0 : 1;
      crop.troubles_at(column + 1, row + 1) = crop.troubles_at(column + 1, row) + in_row;
    }
  }
  return crop;
}

/// Moments of one row of pixels around each node's column.
struct RowMoments {
  double m0 = 0.0;
  double m1 = 0.0;
  double m2 = 0.0;
};

RowMoments row_moments(const float* centre, const AxisWeights& axis, int radius) noexcept {
  RowMoments sum{axis.by_distance[0] * static_cast<double>(centre[0]), 0.0, 0.0};
  for (int k = 1; k <= radius; ++k) {
    const double w = axis.by_distance[static_cast<std::size_t>(k)];
    const auto right = static_cast<double>(centre[k]);
    const auto left = static_cast<double>(centre[-k]);
    sum.m0 += w * (right + left);
    sum.m1 += w * k * (right - left);
    sum.m2 += w * k * k * (right + left);
  }
  return sum;
}

/// The quadratic's value and slopes at the centre of a whole window from the rows' moments `rows[-radius … radius]`,
/// `stride` apart.
InverseDepthPlane whole_window(const RowMoments* centre, std::ptrdiff_t stride, const AxisWeights& axis, int radius) {
  double all = 0.0, u = 0.0, v = 0.0, uu = 0.0, vv = 0.0;
  for (int l = -radius; l <= radius; ++l) {
    const double w = axis.by_distance[static_cast<std::size_t>(std::abs(l))];
    const RowMoments& row = centre[l * stride];
    all += w * row.m0;
    u += w * row.m1;
    v += w * l * row.m0;
    uu += w * row.m2;
    vv += w * l * l * row.m0;
  }
  const double mean = axis.m2 / axis.m0;
  const double bend = (uu + vv - 2.0 * mean * all) / ((axis.m4 - axis.m2 * mean) * axis.m0);
  return {all / (axis.m0 * axis.m0) - mean * bend, u / (axis.m2 * axis.m0), v / (axis.m2 * axis.m0)};
}

/// The node of a plane in inverse depth at a pixel: 1/z = c0 + c1·du + c2·dv is N·X = 1 with N as below.
GridNode node_of(const InverseDepthPlane& plane, double u, double v, const Intrinsics& camera, const Vector3d& origin) {
  const double z = 1.0 / plane.at;
  const Vector3d at((u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z);
  const Vector3d inward(plane.across * camera.fx, plane.down * camera.fy,
                        plane.at + plane.across * (camera.cx - u) + plane.down * (camera.cy - v));
  const Eigen::Vector3f local = (at - origin).cast<float>();
  const Eigen::Vector3f normal = (-inward.normalized()).cast<float>();
  GridNode node;
  node.at_m = {local.x(), local.y(), local.z()};
  node.normal = {normal.x(), normal.y(), normal.z()};
  node.confidence = 1.0F;
  return node;
}

/// Axial noise of a structured-light camera [m]. Source: Nguyen, Izadi and Lovell (2012).
double axial_noise_m(double z_m) noexcept { return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4); }

GridLayout lattice_over(const Intrinsics& camera, const PixelBox& box, int step_px, GridLayout layout) {
  layout.camera = camera;
  layout.left_px = box.left;
  layout.top_px = box.top;
  layout.step_px = step_px;
  layout.columns = (box.width() + step_px - 1) / step_px;
  layout.rows = (box.height() + step_px - 1) / step_px;
  return layout;
}

/// One window size: its weights, and the moments of every row of the crop around every column of nodes.
struct Scale {
  int radius = 0;
  AxisWeights axis;
  std::vector<RowMoments> moments;
};

/// Where the nodes' columns and rows lie in the crop.
struct NodePlaces {
  int left = 0;
  int top = 0;
  int step = 1;
  int columns = 0;
  [[nodiscard]] int column(int node) const noexcept { return left + node * step; }
  [[nodiscard]] int row(int node) const noexcept { return top + node * step; }
};

Scale scale_of(const Crop& crop, const NodePlaces& nodes, int radius) {
  Scale scale{.radius = radius, .axis = axis_weights(radius), .moments = {}};
  const auto columns = static_cast<std::size_t>(nodes.columns);
  scale.moments.resize(columns * static_cast<std::size_t>(crop.height));
  for (int row = 0; row < crop.height; ++row)
    for (int node = 0; node < nodes.columns; ++node) {
      const int column = nodes.column(node);
      if (column < radius || column + radius >= crop.width) continue;
      scale.moments[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(node)] =
          row_moments(&crop.per_m[crop.at(column, row)], scale.axis, radius);
    }
  return scale;
}

bool is_whole(Crop& crop, int column, int row, int radius) noexcept {
  return column >= radius && row >= radius && column + radius < crop.width && row + radius < crop.height &&
         crop.trouble_in(column, row, radius) == 0;
}

InverseDepthPlane plane_at(const Scale& scale, const NodePlaces& nodes, int node_column, int row) noexcept {
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes.columns) + static_cast<std::size_t>(node_column);
  return whole_window(&scale.moments[at], nodes.columns, scale.axis, scale.radius);
}

/// Cosine between the view ray and the surface's normal.
double facing(const InverseDepthPlane& plane, double u, double v, const Intrinsics& camera) noexcept {
  const double x = (u - camera.cx) / camera.fx;
  const double y = (v - camera.cy) / camera.fy;
  const Vector3d inward(plane.across * camera.fx, plane.down * camera.fy,
                        plane.at + plane.across * (camera.cx - u) + plane.down * (camera.cy - v));
  return plane.at / (inward.norm() * std::sqrt(x * x + y * y + 1.0));
}

/// Share of the wide window by slant: a window of pixels covers more of a slanted surface, up to beyond its silhouette,
/// while the noise along the normal falls with the same cosine. So the window shrinks as the surface turns away.
double wide_share(double facing) noexcept {
  constexpr double kNarrowAt = 0.75;
  constexpr double kWideAt = 0.95;
  const double t = std::clamp((facing - kNarrowAt) / (kWideAt - kNarrowAt), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

InverseDepthPlane blended(const InverseDepthPlane& a, const InverseDepthPlane& b, double share_of_a) noexcept {
  const double rest = 1.0 - share_of_a;
  return {share_of_a * a.at + rest * b.at, share_of_a * a.across + rest * b.across,
          share_of_a * a.down + rest * b.down};
}

}  // namespace

void fit_nodes(const DepthField& depth, const Intrinsics& camera, const PixelBox& box, const FitSettings& settings,
               GridLayout& layout, std::vector<GridNode>& nodes) {
  nodes.clear();
  layout = lattice_over(camera, box, settings.step_px, layout);
  if (box.empty()) {
    layout.columns = layout.rows = 0;
    return;
  }
  Crop crop = crop_of(depth, box, settings);
  const NodePlaces places{box.left - crop.left, box.top - crop.top, settings.step_px, layout.columns};
  const Scale wide = scale_of(crop, places, settings.radius_px);
  const Scale narrow = scale_of(crop, places, std::max(2, settings.radius_px / 2));
  const InverseDepthView view{crop.width, crop.height, crop.per_m, crop.breaks};
  nodes.resize(static_cast<std::size_t>(layout.columns) * static_cast<std::size_t>(layout.rows));
  for (int node_row = 0; node_row < layout.rows; ++node_row)
    for (int node_column = 0; node_column < layout.columns; ++node_column) {
      const int column = places.column(node_column);
      const int row = places.row(node_row);
      const double u = crop.left + column;
      const double v = crop.top + row;
      WindowFit fit{.plane = {}, .share = 1.0};
      double gain = wide.axis.gain;
      if (is_whole(crop, column, row, wide.radius)) {
        fit.plane = plane_at(wide, places, node_column, row);
        const double share = wide_share(facing(fit.plane, u, v, camera));
        if (share < 1.0) fit.plane = blended(fit.plane, plane_at(narrow, places, node_column, row), share);
        gain = share * wide.axis.gain + (1.0 - share) * narrow.axis.gain;
      } else if (is_whole(crop, column, row, narrow.radius)) {
        fit.plane = plane_at(narrow, places, node_column, row);
        gain = narrow.axis.gain;
      } else if (const auto part = fit_window(view, column, row, wide.axis.by_distance, settings.bridge_px)) {
        fit = *part;
      } else {
        continue;
      }
      GridNode& node = nodes[static_cast<std::size_t>(node_row) * static_cast<std::size_t>(layout.columns) +
                             static_cast<std::size_t>(node_column)];
      node = node_of(fit.plane, u, v, camera, layout.origin_m);
      node.confidence = static_cast<float>(std::clamp((fit.share - 0.25) / 0.2, 0.0, 1.0));
      const std::size_t pixel = depth.index(crop.left + column, crop.top + row);
      const double frames = depth.weight.empty() ? 1.0 : std::max(1.0F, depth.weight[pixel]);
      node.deviation_m = static_cast<float>(axial_noise_m(1.0 / fit.plane.at) * facing(fit.plane, u, v, camera) *
                                            std::sqrt(gain / (frames * std::max(0.25, fit.share))));
    }
}

}  // namespace telepalp::surface
