#include "clients/ar/isosurface.h"

#include <array>
#include <optional>
#include <unordered_map>

#include "proto/words/demand.h"

namespace telepalp::ar {
namespace {

/// The field at the corners of a grid of cubes.
class Samples {
 public:
  Samples(const Field& field, const Eigen::AlignedBox3f& box, float cell) : cell_(cell), origin_(box.min()) {
    size_ = ((box.sizes() / cell).array().ceil().cast<int>() + 1).matrix();
    demand(size_.minCoeff() > 1 && size_.cast<float>().prod() < 3e7F,
           "the grid of an isosurface has 2 or more points along each axis, and less than 30 million in all");
    values_.reserve(static_cast<std::size_t>(size_.prod()));
    for (int z = 0; z < size_.z(); ++z)
      for (int y = 0; y < size_.y(); ++y)
        for (int x = 0; x < size_.x(); ++x) values_.push_back(field(corner({x, y, z})));
  }
  [[nodiscard]] const Eigen::Vector3i& size() const noexcept { return size_; }
  [[nodiscard]] Eigen::Vector3f corner(const Eigen::Vector3i& at) const { return origin_ + cell_ * at.cast<float>(); }
  [[nodiscard]] float operator()(const Eigen::Vector3i& at) const { return values_[index(at)]; }
  [[nodiscard]] std::size_t index(const Eigen::Vector3i& at) const {
    return static_cast<std::size_t>((at.z() * size_.y() + at.y()) * size_.x() + at.x());
  }

 private:
  float cell_;
  Eigen::Vector3f origin_;
  Eigen::Vector3i size_;
  std::vector<float> values_;
};

/// Mean of the points at which the surface crosses the twelve edges of the cube at `cube`; nullopt without a crossing.
std::optional<Eigen::Vector3f> crossing(const Samples& samples, const Eigen::Vector3i& cube) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  int crossings = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int edge = 0; edge < 4; ++edge) {
      Eigen::Vector3i from = cube;
      from[(axis + 1) % 3] += edge & 1;
      from[(axis + 2) % 3] += edge >> 1;
      Eigen::Vector3i to = from;
      to[axis] += 1;
      const float a = samples(from), b = samples(to);
      if ((a < 0.0F) == (b < 0.0F)) continue;
      sum += samples.corner(from) + (samples.corner(to) - samples.corner(from)) * (a / (a - b));
      ++crossings;
    }
  if (crossings == 0) return std::nullopt;
  return Eigen::Vector3f(sum / static_cast<float>(crossings));
}

Eigen::Vector3f gradient(const Field& field, const Eigen::Vector3f& at, float step) {
  Eigen::Vector3f slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3f offset = step * Eigen::Vector3f::Unit(axis);
    slope[axis] = field(at + offset) - field(at - offset);
  }
  return slope.normalized();
}

}  // namespace

Mesh isosurface(const Field& field, const Eigen::AlignedBox3f& box, float cell_m) {
  const Samples samples(field, box, cell_m);
  Mesh mesh;
  std::unordered_map<std::size_t, std::uint32_t> vertex_of_cube;
  const Eigen::Vector3i cubes = samples.size() - Eigen::Vector3i::Ones();
  for (int z = 0; z < cubes.z(); ++z)
    for (int y = 0; y < cubes.y(); ++y)
      for (int x = 0; x < cubes.x(); ++x)
        if (const auto at = crossing(samples, {x, y, z})) {
          vertex_of_cube[samples.index({x, y, z})] = static_cast<std::uint32_t>(mesh.vertices.size());
          mesh.vertices.push_back({*at, gradient(field, *at, 0.5F * cell_m), Eigen::Vector3f::Ones()});
        }
  // Each crossed grid edge is shared by four cubes: their vertices make two triangles.
  for (int z = 1; z < cubes.z(); ++z)
    for (int y = 1; y < cubes.y(); ++y)
      for (int x = 1; x < cubes.x(); ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3i from(x, y, z), to = from + Eigen::Vector3i::Unit(axis);
          if ((samples(from) < 0.0F) == (samples(to) < 0.0F)) continue;
          const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3), v = Eigen::Vector3i::Unit((axis + 2) % 3);
          const std::array<Eigen::Vector3i, 4> around{from - u - v, from - v, from, from - u};
          std::array<std::uint32_t, 4> quad{};
          for (std::size_t i = 0; i < 4; ++i) quad[i] = vertex_of_cube.at(samples.index(around[i]));
          mesh.triangles.push_back({quad[0], quad[1], quad[2]});
          mesh.triangles.push_back({quad[0], quad[2], quad[3]});
        }
  return mesh;
}

}  // namespace telepalp::ar
