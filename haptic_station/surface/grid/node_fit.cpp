#include "haptic_station/surface/grid/node_fit.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/grid/inverse_crop.h"
#include "haptic_station/surface/grid/node_row.h"
#include "haptic_station/surface/grid/skin_fit.h"
#include "haptic_station/surface/grid/window_fit.h"
#include "proto/words/smooth_step.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kImageAt =
    0.643;  // from this cosine between ray and normal on (50 degrees), the fit in the image counts
constexpr double kSkinAt = 0.545;  // up to this cosine (57 degrees), only the fit on the skin counts

Vector3d vector_of(const std::array<float, 3>& v) noexcept {
  return Eigen::Map<const Eigen::Vector3f>(v.data()).cast<double>();
}

std::array<float, 3> array_of(const Vector3d& v) noexcept {
  const Eigen::Vector3f narrowed = v.cast<float>();
  return {narrowed.x(), narrowed.y(), narrowed.z()};
}

/// Axial noise of a structured-light camera [m]. Source: Nguyen, Izadi and Lovell (2012); make_nodes() uses it, too.
double axial_noise_m(double z_m) noexcept { return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4); }

/// The node at a pixel, from its plane in inverse depth: 1/z = c0 + c1·du + c2·dv is N·X = 1 with N as below.
GridNode node_of(const WindowFit& fit, double u, double v, const GridLayout& layout, double gain, double frames) {
  const Intrinsics& camera = layout.camera;
  const InverseDepthPlane& plane = fit.plane;
  const double z = 1.0 / plane.at;
  const Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  const Vector3d inward(plane.across * camera.fx, plane.down * camera.fy,
                        plane.at + plane.across * (camera.cx - u) + plane.down * (camera.cy - v));
  const double facing = plane.at / (inward.norm() * ray.norm());
  GridNode node;
  node.at_m = array_of(z * ray - layout.origin_m);
  node.normal = array_of(-inward.normalized());
  node.confidence = static_cast<float>(std::clamp((fit.share - 0.25) / 0.2, 0.0, 1.0));
  node.deviation_m =
      static_cast<float>(axial_noise_m(z) * facing * std::sqrt(gain / (frames * std::max(0.25, fit.share))));
  return node;
}

GridLayout lattice_over(const Intrinsics& camera, const PixelBox& box, int step_px, GridLayout layout) {
  layout.camera = camera;
  layout.left_px = box.left;
  layout.top_px = box.top;
  layout.step_px = step_px;
  layout.columns = (box.width() + step_px - 1) / step_px;
  layout.rows = (box.height() + step_px - 1) / step_px;
  return layout;
}

/// The fits of one window size over a row of the crop.
struct ScaleRow {
  ScaleRow(int radius, int width_px)
      : axis(axis_weights(radius)),
        width(width_px),
        at(static_cast<std::size_t>(width_px + kBlock)),
        across(at.size()),
        down(at.size()),
        moments(3 * at.size()) {}

  void fit(const InverseCrop& crop, int row) {
    if (row < axis.radius || row + axis.radius >= crop.height) return;
    const std::size_t length = at.size();
    fit_whole_windows(&crop.per_m[crop.at(0, row)], width, width, axis,
                      {moments.data(), moments.data() + length, moments.data() + 2 * length},
                      {at.data(), across.data(), down.data()});
  }

  AxisWeights axis;
  int width;
  std::vector<float> at, across, down;
  std::vector<float> moments;
};

enum class Window : std::uint8_t { Wide, Narrow, Partial };

/// Makes one row of nodes: chooses each node's window, fits both windows and computes the nodes.
class RowFitter {
 public:
  RowFitter(const DepthField& depth, const InverseCrop& crop, const FitSettings& settings, const GridLayout& layout)
      : depth_(depth),
        crop_(crop),
        settings_(settings),
        layout_(layout),
        wide_(settings.radius_px, crop.width),
        narrow_(std::max(2, (settings.radius_px - 1) / 2), crop.width),
        row_(static_cast<std::size_t>(layout.columns)),
        windows_(row_.x.size()) {
    for (int node = 0; node < layout.columns; ++node)
      row_.ray_x[static_cast<std::size_t>(node)] =
          static_cast<float>((image_column(node) - layout.camera.cx) / layout.camera.fx);
  }

  /// Fills `nodes`, one row of the lattice.
  void fit(int node_row, GridNode* nodes) {
    const int row = static_cast<int>(layout_.top_px) + node_row * settings_.step_px - crop_.top;
    wide_.fit(crop_, row);
    narrow_.fit(crop_, row);
    for (int node = 0; node < layout_.columns; ++node) gather(node, row);
    make_nodes(row_, view_of(row));
    for (int node = 0; node < layout_.columns; ++node) {
      const auto n = static_cast<std::size_t>(node);
      if (windows_[n] == Window::Partial)
        fit_part(node, row, nodes[node]);
      else
        scatter(n, nodes[node]);
      if (windows_[n] == Window::Partial ? nodes[node].confidence > 0.0F : row_.facing[n] < kImageAt)
        refit_on_skin(node, row, nodes[node]);
    }
  }

 private:
  [[nodiscard]] int crop_column(int node) const noexcept {
    return static_cast<int>(layout_.left_px) + node * settings_.step_px - crop_.left;
  }
  [[nodiscard]] double image_column(int node) const noexcept { return layout_.left_px + node * settings_.step_px; }

  [[nodiscard]] float frames_at(int column, int row) const noexcept {
    const std::size_t pixel = depth_.index(crop_.left + column, crop_.top + row);
    return depth_.weight.empty() ? 1.0F : std::max(1.0F, depth_.weight[pixel]);
  }

  void gather(int node, int row) {
    const int column = crop_column(node);
    const auto n = static_cast<std::size_t>(node);
    const auto u = static_cast<std::size_t>(column);
    windows_[n] = crop_.is_whole(column, row, wide_.axis.radius)     ? Window::Wide
                  : crop_.is_whole(column, row, narrow_.axis.radius) ? Window::Narrow
                                                                     : Window::Partial;
    const ScaleRow& outer = windows_[n] == Window::Wide ? wide_ : narrow_;
    row_.wide[n] = windows_[n] == Window::Wide ? 1.0F : 0.0F;
    row_.wide_at[n] = outer.at[u];
    row_.wide_across[n] = outer.across[u];
    row_.wide_down[n] = outer.down[u];
    row_.narrow_at[n] = narrow_.at[u];
    row_.narrow_across[n] = narrow_.across[u];
    row_.narrow_down[n] = narrow_.down[u];
    row_.frames[n] = frames_at(column, row);
  }

  [[nodiscard]] NodeRowView view_of(int row) const noexcept {
    const auto narrowed = [](double value) { return static_cast<float>(value); };
    const Vector3d& origin = layout_.origin_m;
    return {.fx = narrowed(layout_.camera.fx),
            .fy = narrowed(layout_.camera.fy),
            .ray_y = narrowed((crop_.top + row - layout_.camera.cy) / layout_.camera.fy),
            .origin_x = narrowed(origin.x()),
            .origin_y = narrowed(origin.y()),
            .origin_z = narrowed(origin.z()),
            .reference_per_m = crop_.reference_per_m,
            .wide_gain = narrowed(wide_.axis.gain),
            .narrow_gain = narrowed(narrow_.axis.gain)};
  }

  void scatter(std::size_t n, GridNode& node) const noexcept {
    node.at_m = {row_.x[n], row_.y[n], row_.z[n]};
    node.normal = {row_.normal_x[n], row_.normal_y[n], row_.normal_z[n]};
    node.confidence = 1.0F;
    node.deviation_m = row_.deviation[n];
  }

  void fit_part(int node, int row, GridNode& out) const {
    const int column = crop_column(node);
    std::optional<WindowFit> fit = fit_window(crop_.view(), column, row, wide_.axis, settings_.bridge_px);
    if (!fit) return;
    fit->plane.at += static_cast<double>(crop_.reference_per_m);
    out = node_of(*fit, image_column(node), crop_.top + row, layout_, wide_.axis.gain,
                  static_cast<double>(frames_at(column, row)));
  }

  /// Replaces the fit in the image by one on the skin, where the skin is steep; blends both in between.
  void refit_on_skin(int node, int row, GridNode& out) const {
    const SkinPoint start{layout_.origin_m + vector_of(out.at_m), vector_of(out.normal)};
    const double share = 1.0 - smooth_step(kSkinAt, kImageAt, facing_of(start));
    if (share <= 0.0) return;
    const Pixel centre{crop_column(node), row};
    const int radius = wide_.axis.radius;
    const std::optional<WindowMask> mask =
        windows_[static_cast<std::size_t>(node)] == Window::Wide
            ? whole_window(centre, radius)
            : connected_pixels(crop_.view(), centre.column, centre.row, radius, settings_.bridge_px);
    if (!mask) return;
    const auto fit = fit_on_skin(crop_.view(), {layout_.camera, crop_.left, crop_.top}, *mask, centre, radius, start);
    if (!fit) return;
    const auto frames = static_cast<double>(frames_at(centre.column, centre.row));
    const double deviation_m = axial_noise_m(fit->point.at.z()) * facing_of(fit->point) * std::sqrt(fit->gain / frames);
    out.at_m = array_of((1.0 - share) * start.at + share * fit->point.at - layout_.origin_m);
    out.normal = array_of(((1.0 - share) * start.normal + share * fit->point.normal).normalized());
    out.deviation_m += static_cast<float>(share * (deviation_m - static_cast<double>(out.deviation_m)));
  }

  const DepthField& depth_;
  const InverseCrop& crop_;
  const FitSettings& settings_;
  const GridLayout& layout_;
  ScaleRow wide_;
  ScaleRow narrow_;
  NodeRow row_;
  std::vector<Window> windows_;
};

}  // namespace

void fit_nodes(const DepthField& depth, const Intrinsics& camera, const PixelBox& box, const FitSettings& settings,
               GridLayout& layout, std::vector<GridNode>& nodes) {
  nodes.clear();
  layout = lattice_over(camera, box, settings.step_px, layout);
  if (box.empty()) {
    layout.columns = layout.rows = 0;
    return;
  }
  const InverseCrop crop = crop_of(depth, box, settings.radius_px, settings.break_m);
  const auto columns = static_cast<std::size_t>(layout.columns);
  nodes.reserve(columns * static_cast<std::size_t>(layout.rows));
  RowFitter fitter(depth, crop, settings, layout);
  for (int row = 0; row < layout.rows; ++row) {
    nodes.resize(nodes.size() + columns);  // row by row, so that a row is still in the cache when it is filled
    fitter.fit(row, &nodes[nodes.size() - columns]);
  }
}

}  // namespace telepalp::surface
