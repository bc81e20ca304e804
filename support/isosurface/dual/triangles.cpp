#include "support/isosurface/dual/triangles.h"

#include <algorithm>

#include "support/isosurface/cells/key_map.h"

namespace telepalp::isosurface {
namespace {

using Eigen::Vector3d;
using Outline = std::vector<std::uint32_t>;

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) noexcept {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

class Cutter {
 public:
  Cutter(const std::vector<Polygon>& polygons, const Pieces& pieces, std::vector<Vector3d> vertices)
      : polygons_(polygons), pieces_(pieces) {
    mesh_.points = std::move(vertices);
    mesh_.points.insert(mesh_.points.end(), pieces.middles.begin(), pieces.middles.end());
  }

  Mesh cut() {
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      const Outline outline = outline_of(p);
      for (std::size_t i = 0; i < outline.size(); ++i)
        edges_.insert(edge_key(outline[i], outline[(i + 1) % outline.size()]));
    }
    for (std::size_t p = 0; p < polygons_.size(); ++p) cut(outline_of(p), polygons_[p].crossing);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] Outline outline_of(std::size_t p) const {
    Outline outline;
    for (std::size_t i = 0; i < polygons_[p].corners; ++i) {
      outline.push_back(pieces_.vertex[4 * p + i]);
      const std::int32_t middle = pieces_.middle[4 * p + i];
      if (middle >= 0)
        outline.push_back(static_cast<std::uint32_t>(pieces_.count) + static_cast<std::uint32_t>(middle));
    }
    return outline;
  }

  void cut(const Outline& o, const Plane& crossing) {
    if (o.size() == 3) return add(o[0], o[1], o[2]);
    if (o.size() == 4) {
      const bool first = evenness(o, 0, crossing) >= evenness(o, 1, crossing);
      for (const std::size_t turn : {first ? 0U : 1U, first ? 1U : 0U})
        if (edges_.insert(edge_key(o[turn], o[turn + 2])).second) {
          add(o[turn], o[turn + 1], o[turn + 2]);
          add(o[turn + 2], o[(turn + 3) % 4], o[turn]);
          return;
        }
    }
    const auto middle = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.push_back(crossing.at);
    for (std::size_t i = 0; i < o.size(); ++i) add(o[i], o[(i + 1) % o.size()], middle);
  }

  /// How well both triangles of a quadrilateral, cut from corner `turn`, face the surface's normal; 1: exactly.
  [[nodiscard]] double evenness(const Outline& o, std::size_t turn, const Plane& crossing) const {
    const auto facing = [&](std::size_t a, std::size_t b, std::size_t c) {
      const Vector3d across = (mesh_.points[o[b]] - mesh_.points[o[a]]).cross(mesh_.points[o[c]] - mesh_.points[o[a]]);
      const double twice_area = across.norm();
      return twice_area > 0.0 ? across.dot(crossing.normal) / twice_area : -1.0;
    };
    return std::min(facing(turn, turn + 1, turn + 2), facing(turn + 2, (turn + 3) % 4, turn));
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.push_back({a, b, c}); }

  const std::vector<Polygon>& polygons_;
  const Pieces& pieces_;
  Mesh mesh_;
  KeyMap<char> edges_;
};

}  // namespace

Mesh triangulated(const std::vector<Polygon>& polygons, const Pieces& pieces, std::vector<Vector3d> vertices) {
  return Cutter(polygons, pieces, std::move(vertices)).cut();
}

}  // namespace telepalp::isosurface
