#include "haptic_station/surface/grid/window_mask.h"

#include <algorithm>
#include <cstdlib>

namespace telepalp::surface {
namespace {

using Bits = std::uint32_t;

bool measured(const InverseDepthView& view, Pixel at) noexcept {
  return at.column >= 0 && at.row >= 0 && at.column < view.width && at.row < view.height &&
         (view.measured.from(at.column, at.row) & 1U) != 0;
}

std::optional<Pixel> nearest_measured(const InverseDepthView& view, Pixel centre, int most) noexcept {
  for (int ring = 0; ring <= most; ++ring)
    for (int dv = -ring; dv <= ring; ++dv)
      for (int du = -ring; du <= ring; ++du) {
        const Pixel at{centre.column + du, centre.row + dv};
        if (std::max(std::abs(du), std::abs(dv)) == ring && measured(view, at)) return at;
      }
  return std::nullopt;
}

/// One row of a window as bit masks, bit k for pixel k: measured, linked to the right, linked to the pixel below.
struct WindowRow {
  Bits measured = 0;
  Bits right = 0;
  Bits below = 0;
};

using WindowRows = std::array<WindowRow, kMostSide>;

void read_rows(const InverseDepthView& view, Pixel corner, int side, WindowRows& rows) noexcept {
  const Bits inside = ~Bits{0} >> (32 - side);
  for (int l = 0; l < side; ++l) {
    WindowRow& out = rows[static_cast<std::size_t>(l)];
    const int row = corner.row + l;
    out = row < 0 || row >= view.height
              ? WindowRow{}
              : WindowRow{view.measured.from(corner.column, row) & inside,
                          view.right.from(corner.column, row) & (inside >> 1), view.below.from(corner.column, row)};
  }
}

/// The pixels of a row that are connected to a pixel in `reached` by links to the right (bit k links k and k + 1).
Bits along_row(Bits reached, Bits right) noexcept {
  Bits up = right << 1;  // bit k: linked to k - 1
  Bits down = right;     // bit k: linked to k + 1
  for (int step = 1; step < kMostSide; step *= 2) {
    reached |= (up & (reached << step)) | (down & (reached >> step));
    up &= up << step;
    down &= down >> step;
  }
  return reached;
}

/// Finds the window's pixels that are connected to `start`: sweeps down and up until no pixel is added.
void connect(const WindowRows& rows, int side, Pixel start, std::array<Bits, kMostSide>& reached) noexcept {
  reached.fill(0);
  const auto first = static_cast<std::size_t>(start.row);
  reached[first] = along_row(Bits{1} << start.column, rows[first].right);
  const auto grow = [&](int l, Bits from) {
    const auto at = static_cast<std::size_t>(l);
    if ((from & ~reached[at]) == 0) return false;
    const Bits grown = along_row(reached[at] | (from & rows[at].measured), rows[at].right);
    const bool changed = grown != reached[at];
    reached[at] = grown;
    return changed;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int l = 1; l < side; ++l)
      changed |= grow(l, reached[static_cast<std::size_t>(l) - 1] & rows[static_cast<std::size_t>(l) - 1].below);
    for (int l = side - 2; l >= 0; --l)
      changed |= grow(l, reached[static_cast<std::size_t>(l) + 1] & rows[static_cast<std::size_t>(l)].below);
  }
}

}  // namespace

BitRows::BitRows(int width, int height)
    : stride_(static_cast<std::size_t>((width + 63) / 64) + 2), words_(stride_ * static_cast<std::size_t>(height), 0) {}

WindowMask whole_window(Pixel centre, int radius) noexcept {
  const int side = 2 * radius + 1;
  WindowMask mask{.rows = {}, .start = centre};
  std::fill_n(mask.rows.begin(), side, ~Bits{0} >> (32 - side));
  return mask;
}

std::optional<WindowMask> connected_pixels(const InverseDepthView& view, int column, int row, int radius,
                                           int bridge_px) {
  const std::optional<Pixel> start = nearest_measured(view, {column, row}, std::min(bridge_px, radius));
  if (!start) return std::nullopt;
  const int side = 2 * radius + 1;
  const Pixel corner{column - radius, row - radius};
  WindowRows rows;
  read_rows(view, corner, side, rows);
  WindowMask mask{.rows = {}, .start = *start};
  connect(rows, side, {start->column - corner.column, start->row - corner.row}, mask.rows);
  return mask;
}

}  // namespace telepalp::surface
