#include "clients/mixed/view/mask.h"

#include <algorithm>
#include <cmath>

namespace telepalp::mixed {
namespace {

using Eigen::Vector2d;

double turn(const Vector2d& from, const Vector2d& over, const Vector2d& to) {
  return (over.x() - from.x()) * (to.y() - from.y()) - (over.y() - from.y()) * (to.x() - from.x());
}

/// The corners of the convex hull in one sense of rotation: Andrew's monotone chain.
std::vector<Vector2d> hull_of(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Vector2d& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
      hull.push_back(point);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The interval of x in which the hull crosses row `y`.
void cross(const std::vector<Vector2d>& hull, double y, double& least, double& most) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d& a = hull[i];
    const Vector2d& b = hull[(i + 1) % hull.size()];
    if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y) continue;
    const double along = a.y() == b.y() ? 0.0 : (y - a.y()) / (b.y() - a.y());
    const double x = a.x() + along * (b.x() - a.x());
    least = std::min({least, x, a.y() == b.y() ? b.x() : x});
    most = std::max({most, x, a.y() == b.y() ? b.x() : x});
  }
}

constexpr std::uint8_t kFar = 255;  // thirds of a pixel: the largest distance

/// The new distance of a pixel, from its own one and those of its neighbours: one beside it, three in the row above or
/// below.
std::uint8_t nearer(int own, int beside, int diagonal, int across, int other_diagonal) noexcept {
  const int straight = std::min(beside, across) + 3, oblique = std::min(diagonal, other_diagonal) + 4;
  return static_cast<std::uint8_t>(std::min({own, straight, oblique, int{kFar}}));
}

}  // namespace

std::size_t Mask::count() const noexcept {
  return on.size() - static_cast<std::size_t>(std::count(on.begin(), on.end(), std::uint8_t{0}));
}

Box Box::grown(int by_px, int width, int height) const noexcept {
  if (empty()) return *this;
  return {std::max(left - by_px, 0), std::max(top - by_px, 0), std::min(right + by_px, width),
          std::min(bottom + by_px, height)};
}

Box box_of(const Mask& mask) noexcept {
  Box box{mask.width, mask.height, 0, 0};
  for (int y = 0; y < mask.height; ++y) {
    const std::uint8_t* const row = mask.on.data() + mask.index(0, y);
    int left = 0, right = mask.width;
    while (left < right && row[left] == 0) ++left;
    if (left == right) continue;
    while (row[right - 1] == 0) --right;
    box = {std::min(box.left, left), std::min(box.top, y), std::max(box.right, right), y + 1};
  }
  return box;
}

void add(Mask& mask, const Mask& more) noexcept {
  for (std::size_t i = 0; i < mask.on.size(); ++i) mask.on[i] |= more.on[i];
}

Mask both(const Mask& one, const Mask& other) {
  Mask mask = one;
  for (std::size_t i = 0; i < mask.on.size(); ++i) mask.on[i] &= other.on[i];
  return mask;
}

void fill_hull(Mask& mask, std::span<const Vector2d> points) {
  const std::vector<Vector2d> hull = hull_of({points.begin(), points.end()});
  if (hull.size() < 3) return;
  const auto [low, high] =
      std::minmax_element(hull.begin(), hull.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  const int bottom = static_cast<int>(std::min(std::floor(high->y()), mask.height - 1.0));
  for (int y = static_cast<int>(std::max(std::ceil(low->y()), 0.0)); y <= bottom; ++y) {
    double least = 1e9, most = -1e9;
    cross(hull, y, least, most);
    const int right = static_cast<int>(std::clamp(std::floor(most), -1.0, mask.width - 1.0));
    for (int x = static_cast<int>(std::clamp(std::ceil(least), 0.0, mask.width + 0.0)); x <= right; ++x)
      mask.on[mask.index(x, y)] = 1;
  }
}

std::vector<std::uint8_t> distance_outside(const Mask& mask, int radius_px) {
  std::vector<std::uint8_t> distance(mask.on.size(), kFar);
  const Box box = box_of(mask).grown(radius_px, mask.width, mask.height);
  if (box.empty()) return distance;
  // A copy of the box with a margin of one pixel, so that each pixel has eight neighbours.
  const int width = box.right - box.left, height = box.bottom - box.top;
  const std::ptrdiff_t row = width + 2;
  std::vector<std::uint8_t> padded(static_cast<std::size_t>(row * (height + 2)), kFar);
  const auto line = [&](int y) { return padded.data() + row * (y + 1) + 1; };
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* const on = mask.on.data() + mask.index(box.left, box.top + y);
    std::uint8_t* const at = line(y);
    for (int x = 0; x < width; ++x)
      at[x] = on[x] != 0 ? std::uint8_t{0} : nearer(at[x], at[x - 1], at[x - row - 1], at[x - row], at[x - row + 1]);
  }
  for (int y = height - 1; y >= 0; --y) {
    std::uint8_t* const at = line(y);
    for (int x = width - 1; x >= 0; --x)
      at[x] = nearer(at[x], at[x + 1], at[x + row + 1], at[x + row], at[x + row - 1]);
    std::copy(at, at + width, distance.begin() + static_cast<std::ptrdiff_t>(mask.index(box.left, box.top + y)));
  }
  return distance;
}

}  // namespace telepalp::mixed
