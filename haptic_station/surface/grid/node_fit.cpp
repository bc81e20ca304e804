#include "haptic_station/surface/grid/node_fit.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/grid/node_row.h"
#include "haptic_station/surface/grid/window_fit.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

/// The pixels of the box, with a border of the fit's radius within the image: their inverse depth, the links between
/// neighbours, and a summed-area table of the pixels that a complete window must not contain.
struct Crop {
  Crop(const PixelBox& box, int image_width, int image_height, int margin)
      : left(std::max(0, box.left - margin)),
        top(std::max(0, box.top - margin)),
        width(std::min(image_width, box.right + margin) - left),
        height(std::min(image_height, box.bottom + margin) - top),
        per_m(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + kBlock),
        measured(width, height),
        right(width, height),
        below(width, height),
        troubles(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {}

  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  float reference_per_m = 0.0F;
  std::vector<float> per_m;  ///< inverse depth minus the reference
  BitRows measured;
  BitRows right;              ///< linked to the right neighbour
  BitRows below;              ///< linked to the one below
  std::vector<int> troubles;  ///< summed-area table, (width + 1) × (height + 1)

  [[nodiscard]] std::size_t at(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] int troubles_at(int column, int row) const noexcept {
    return troubles[static_cast<std::size_t>(row) * static_cast<std::size_t>(width + 1) +
                    static_cast<std::size_t>(column)];
  }
  [[nodiscard]] bool is_whole(int column, int row, int radius) const noexcept {
    return column >= radius && row >= radius && column + radius < width && row + radius < height &&
           troubles_at(column + radius + 1, row + radius + 1) + troubles_at(column - radius, row - radius) ==
               troubles_at(column - radius, row + radius + 1) + troubles_at(column + radius + 1, row - radius);
  }
};

/// A reference for the inverse depths of the crop: any measured one. The differences are small, and so is their
/// rounding.
float reference_in(const DepthField& depth, const Crop& crop) {
  constexpr int kEvery = 7;
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < crop.height; row += kEvery)
    for (int column = 0; column < crop.width; column += kEvery)
      if (const float z = depth.z_m[depth.index(crop.left + column, crop.top + row)]; z > 0.0F) {
        sum += 1.0 / static_cast<double>(z);
        ++count;
      }
  return count > 0 ? static_cast<float>(sum / count) : 0.0F;
}

/// Links two neighbouring pixels if both are measured and there is no depth break between them.
void link(Crop& crop) {
  for (int row = 0; row < crop.height; ++row) {
    const std::uint64_t* measured = crop.measured.row(row);
    const std::uint64_t* next = crop.measured.row(std::min(row + 1, crop.height - 1));
    std::uint64_t* right = crop.right.row(row);  // these bits mark depth breaks so far
    std::uint64_t* below = crop.below.row(row);
    for (std::size_t word = 0; word < crop.measured.words(); ++word) {
      const std::uint64_t to_the_right = measured[word] >> 1 | measured[word + 1] << 63;
      right[word] = measured[word] & to_the_right & ~right[word];
      below[word] = measured[word] & next[word] & ~below[word];
    }
  }
}

Crop crop_of(const DepthField& depth, const PixelBox& box, const FitSettings& settings) {
  Crop crop(box, depth.width, depth.height, settings.radius_px);
  crop.reference_per_m = reference_in(depth, crop);
  const auto width = static_cast<std::size_t>(crop.width);
  std::vector<std::uint8_t> marks(width);
  for (int row = 0; row < crop.height; ++row) {
    const float* z_m = &depth.z_m[depth.index(crop.left, crop.top + row)];
    const float* below = row + 1 < crop.height ? z_m + depth.width : z_m;
    invert_row(z_m, crop.width, crop.reference_per_m, &crop.per_m[crop.at(0, row)]);
    mark_row(z_m, below, crop.width, static_cast<float>(settings.break_m), marks.data());
    pack_row(marks.data(), crop.width, kMeasured, crop.measured.row(row));
    pack_row(marks.data(), crop.width, kBrokenRight, crop.right.row(row));
    pack_row(marks.data(), crop.width, kBrokenBelow, crop.below.row(row));
    const int* above = &crop.troubles[static_cast<std::size_t>(row) * (width + 1)];
    int* counts = &crop.troubles[static_cast<std::size_t>(row + 1) * (width + 1)];
    int in_row = 0;
    for (std::size_t u = 0; u < width; ++u) {
      in_row += marks[u] == kMeasured ? 0 : 1;
      counts[u + 1] = above[u + 1] + in_row;
    }
  }
  link(crop);
  return crop;
}

/// The node at a pixel, from its plane in inverse depth: 1/z = c0 + c1·du + c2·dv is N·X = 1 with N as below.
GridNode node_of(const WindowFit& fit, double u, double v, const GridLayout& layout, double gain, double frames) {
  const Intrinsics& camera = layout.camera;
  const InverseDepthPlane& plane = fit.plane;
  const double z = 1.0 / plane.at;
  const Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  const Vector3d inward(plane.across * camera.fx, plane.down * camera.fy,
                        plane.at + plane.across * (camera.cx - u) + plane.down * (camera.cy - v));
  const Eigen::Vector3f local = (z * ray - layout.origin_m).cast<float>();
  const Eigen::Vector3f normal = (-inward.normalized()).cast<float>();
  const double facing = plane.at / (inward.norm() * ray.norm());
  const double axial_m = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);  // as in make_nodes()
  GridNode node;
  node.at_m = {local.x(), local.y(), local.z()};
  node.normal = {normal.x(), normal.y(), normal.z()};
  node.confidence = static_cast<float>(std::clamp((fit.share - 0.25) / 0.2, 0.0, 1.0));
  node.deviation_m = static_cast<float>(axial_m * facing * std::sqrt(gain / (frames * std::max(0.25, fit.share))));
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

  void fit(const Crop& crop, int row) {
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
  RowFitter(const DepthField& depth, const Crop& crop, const FitSettings& settings, const GridLayout& layout)
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
    for (int node = 0; node < layout_.columns; ++node)
      if (windows_[static_cast<std::size_t>(node)] == Window::Partial)
        fit_part(node, row, nodes[node]);
      else
        scatter(static_cast<std::size_t>(node), nodes[node]);
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
    const InverseDepthView view{crop_.width, crop_.height, crop_.per_m,          crop_.measured,
                                crop_.right, crop_.below,  crop_.reference_per_m};
    std::optional<WindowFit> fit = fit_window(view, column, row, wide_.axis, settings_.bridge_px);
    if (!fit) return;
    fit->plane.at += static_cast<double>(crop_.reference_per_m);
    out = node_of(*fit, image_column(node), crop_.top + row, layout_, wide_.axis.gain,
                  static_cast<double>(frames_at(column, row)));
  }

  const DepthField& depth_;
  const Crop& crop_;
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
  const Crop crop = crop_of(depth, box, settings);
  const auto columns = static_cast<std::size_t>(layout.columns);
  nodes.reserve(columns * static_cast<std::size_t>(layout.rows));
  RowFitter fitter(depth, crop, settings, layout);
  for (int row = 0; row < layout.rows; ++row) {
    nodes.resize(nodes.size() + columns);  // row by row, so that a row is still in the cache when it is filled
    fitter.fit(row, &nodes[nodes.size() - columns]);
  }
}

}  // namespace telepalp::surface
