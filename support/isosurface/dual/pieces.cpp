#include "support/isosurface/dual/pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "proto/words/demand.h"

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;

/// The side of a polygon that crosses the face between two leaves.
struct Side {
  std::uint64_t face;    ///< both leaves, the smaller index in the high half
  std::uint32_t number;  ///< 4 * polygon + corner
};

/// A face between two leaves: the common part of their boundaries.
struct Face {
  Vector3d middle;
  int axis;  ///< perpendicular to the face
};

Face face_between(const CellTree& tree, std::uint64_t leaves) {
  const Leaf& a = tree.leaves()[leaves >> 32];
  const Leaf& b = tree.leaves()[leaves & 0xffffffffU];
  const Eigen::Vector3i low = a.low.cwiseMax(b.low);
  const Eigen::Vector3i high =
      (a.low.array() + tree.lattice().side(a.level)).min(b.low.array() + tree.lattice().side(b.level)).matrix();
  Face face{.middle = 0.5 * (tree.lattice().at(low) + tree.lattice().at(high)), .axis = 0};
  (high - low).minCoeff(&face.axis);
  return face;
}

class Joiner {
 public:
  Joiner(const std::vector<Polygon>& polygons, const CellTree& tree, const Field& field)
      : polygons_(polygons), tree_(tree), field_(field), above_(4 * polygons.size()) {
    std::iota(above_.begin(), above_.end(), 0U);
    out_.middle.assign(above_.size(), -1);
  }

  Pieces join() {
    std::vector<Side> sides = all_sides();
    std::ranges::sort(
        sides, [](const Side& a, const Side& b) { return a.face != b.face ? a.face < b.face : a.number < b.number; });
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t end = first;
      while (end < sides.size() && sides[end].face == sides[first].face) ++end;
      const std::span<Side> together(sides.data() + first, end - first);
      demand(together.size() % 2 == 0, "a closed curve crosses the surface an even number of times");
      if (together.size() == 2)
        pair(together[0].number, together[1].number);
      else
        pair_around(together);
      first = end;
    }
    number_pieces();
    return std::move(out_);
  }

 private:
  std::vector<Side> all_sides() const {
    std::vector<Side> sides;
    sides.reserve(above_.size());
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      for (std::size_t i = 0; i < polygons_[p].corners; ++i) {
        const auto a = static_cast<std::uint64_t>(polygons_[p].leaf[i]);
        const auto b = static_cast<std::uint64_t>(polygons_[p].leaf[polygons_[p].after(i)]);
        sides.push_back({std::min(a, b) << 32 | std::max(a, b), static_cast<std::uint32_t>(4 * p + i)});
      }
    return sides;
  }

  [[nodiscard]] std::uint32_t end_of(std::uint32_t side) const noexcept {
    return side / 4 * 4 + static_cast<std::uint32_t>(polygons_[side / 4].after(side % 4));
  }

  /// Two sides run along each other in opposite directions.
  void pair(std::uint32_t one, std::uint32_t other) {
    unite(one, end_of(other));
    unite(end_of(one), other);
  }

  /// More than two sides on one face: orders their crossings around the face, and joins the two ends of each arc that
  /// lies on the other side of the surface than the face's middle.
  void pair_around(std::span<Side> sides) {
    const Face face = face_between(tree_, sides.front().face);
    const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    const auto from_middle = [&](const Side& side) {
      return Vector3d(polygons_[side.number / 4].crossing.at - face.middle);
    };
    const auto angle = [&](const Side& side) {
      const Vector3d from = from_middle(side);
      return std::atan2(from[v], from[u]);
    };
    std::ranges::sort(sides, {}, angle);
    const bool middle_inside = field_.m_at(face.middle) < 0.0;
    const Vector3d from = from_middle(sides[0]);
    const Vector3d& outwards = polygons_[sides[0].number / 4].outwards;
    const bool then_outside = from[u] * outwards[v] - from[v] * outwards[u] > 0.0;
    const std::size_t first = then_outside == middle_inside ? 0 : 1;
    for (std::size_t i = first; i < sides.size() + first; i += 2) {
      const std::uint32_t one = sides[i % sides.size()].number;
      const std::uint32_t other = sides[(i + 1) % sides.size()].number;
      pair(one, other);
      out_.middle[one] = out_.middle[other] = static_cast<std::int32_t>(out_.middles.size());
      out_.middles.emplace_back(0.5 * (polygons_[one / 4].crossing.at + polygons_[other / 4].crossing.at));
    }
  }

  void number_pieces() {
    constexpr std::uint32_t kNone = 0xffffffff;
    out_.vertex.assign(above_.size(), kNone);
    std::vector<std::uint32_t> of_root(above_.size(), kNone);
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      for (std::size_t i = 0; i < polygons_[p].corners; ++i) {
        std::uint32_t& number = of_root[root(static_cast<std::uint32_t>(4 * p + i))];
        if (number == kNone) number = static_cast<std::uint32_t>(out_.count++);
        out_.vertex[4 * p + i] = number;
      }
  }

  std::uint32_t root(std::uint32_t corner) noexcept {
    while (above_[corner] != corner) corner = above_[corner] = above_[above_[corner]];
    return corner;
  }
  void unite(std::uint32_t a, std::uint32_t b) noexcept { above_[root(a)] = root(b); }

  const std::vector<Polygon>& polygons_;
  const CellTree& tree_;
  const Field& field_;
  std::vector<std::uint32_t> above_;  // union-find over corners
  Pieces out_;
};

}  // namespace

Pieces pieces_of(const std::vector<Polygon>& polygons, const CellTree& tree, const Field& field) {
  return Joiner(polygons, tree, field).join();
}

}  // namespace telepalp::isosurface
