#include "haptic_station/solids/solid.h"

#include <cmath>

#include "proto/words/error_line.h"

namespace telepalp::solids {
namespace {

using enum Unit;

constexpr NumberKind kSphere[] = {{"radius_m", Length}};
constexpr NumberKind kPlane[] = {
    {"normal_x", Direction}, {"normal_y", Direction}, {"normal_z", Direction}, {"offset_m", Coordinate}};
constexpr NumberKind kCapsule[] = {{"from_x_m", Coordinate}, {"from_y_m", Coordinate}, {"from_z_m", Coordinate},
                                   {"to_x_m", Coordinate},   {"to_y_m", Coordinate},   {"to_z_m", Coordinate},
                                   {"radius_m", Length}};
constexpr NumberKind kTorus[] = {{"ring_radius_m", Length}, {"tube_radius_m", Length}};
constexpr NumberKind kArc[] = {
    {"ring_radius_m", Length}, {"tube_radius_m", Length}, {"from_deg", Degrees}, {"to_deg", Degrees}};
constexpr NumberKind kBox[] = {{"half_x_m", Length}, {"half_y_m", Length}, {"half_z_m", Length}};
constexpr NumberKind kEllipsoid[] = {{"radius_x_m", Length}, {"radius_y_m", Length}, {"radius_z_m", Length}};
constexpr NumberKind kCylinder[] = {{"radius_m", Length}, {"half_length_m", Length}};
constexpr NumberKind kMesh[] = {{"unit_m", Factor}, {"cell_m", Length}};
constexpr NumberKind kBlend[] = {{"width_m", Length}};
constexpr NumberKind kTranslate[] = {{"x_m", Coordinate}, {"y_m", Coordinate}, {"z_m", Coordinate}};
constexpr NumberKind kTransform[] = {{"x_m", Coordinate},   {"y_m", Coordinate},   {"z_m", Coordinate},
                                     {"turn_deg", Degrees}, {"axis_x", Direction}, {"axis_y", Direction},
                                     {"axis_z", Direction}};
constexpr NumberKind kRotate[] = {
    {"turn_deg", Degrees}, {"axis_x", Direction}, {"axis_y", Direction}, {"axis_z", Direction}};
constexpr NumberKind kScale[] = {{"factor", Factor}};

constexpr Word kWords[] = {
    {"sphere", "sphere", Op::Sphere, 0, 0, kSphere},
    {"plane", "plane", Op::Plane, 0, 0, kPlane},
    {"capsule", "capsule", Op::Capsule, 0, 0, kCapsule},
    {"torusx", "torusx", Op::Torus, 0, 0, kTorus},
    {"torusy", "torusy", Op::Torus, 1, 0, kTorus},
    {"torusz", "torusz", Op::Torus, 2, 0, kTorus},
    {"arcx", "arcx", Op::Arc, 0, 0, kArc},
    {"arcy", "arcy", Op::Arc, 1, 0, kArc},
    {"arcz", "arcz", Op::Arc, 2, 0, kArc},
    {"box", "box", Op::Box, 0, 0, kBox},
    {"ellipsoid", "ellipsoid", Op::Ellipsoid, 0, 0, kEllipsoid},
    {"cylinderx", "cylinderx", Op::Cylinder, 0, 0, kCylinder},
    {"cylindery", "cylindery", Op::Cylinder, 1, 0, kCylinder},
    {"cylinderz", "cylinderz", Op::Cylinder, 2, 0, kCylinder},
    {"mesh", "mesh", Op::Mesh, 0, 0, kMesh},
    {"+", "union", Op::Union, 0, 2, {}},
    {"*", "intersection", Op::Intersection, 0, 2, {}},
    {"-", "difference", Op::Difference, 0, 2, {}},
    {"blend", "blend", Op::Blend, 0, 2, kBlend},
    {"clip", "clip", Op::Clip, 0, 1, kPlane},
    {"tr", "translate", Op::Translate, 0, 1, kTranslate},
    {"tx", "transform", Op::Transform, 0, 1, kTransform},
    {"ro", "rotate", Op::Rotate, 0, 1, kRotate},
    {"sc", "scale", Op::Scale, 0, 1, kScale},
};

struct Bounds {
  double least;
  double most;
  const char* meaning;
};

Bounds bounds_of(Unit unit) noexcept {
  switch (unit) {
    case Coordinate:
      return {-1000.0, 1000.0, "a position in metres"};
    case Length:
      return {1e-6, 1000.0, "a length above zero, in metres"};
    case Direction:
      return {-1e6, 1e6, "a component of a direction"};
    case Degrees:
      return {-720.0, 720.0, "an angle in degrees"};
    case Factor:
      return {1e-6, 1e6, "a factor above zero"};
  }
  return {0.0, 0.0, ""};
}

/// The index of the first of three numbers that are a direction; nullopt for a word without one.
std::optional<std::size_t> direction_of(const Word& word) noexcept {
  for (std::size_t i = 0; i < word.numbers.size(); ++i)
    if (word.numbers[i].unit == Direction) return i;
  return std::nullopt;
}

std::optional<Complaint> range_complaint(const Node& node) {
  for (std::size_t i = 0; i < node.kind().numbers.size(); ++i) {
    const NumberKind& kind = node.kind().numbers[i];
    const Bounds bounds = bounds_of(kind.unit);
    if (std::isfinite(node.numbers[i]) && node.numbers[i] >= bounds.least && node.numbers[i] <= bounds.most) continue;
    return Complaint{
        .what = std::string(kind.name) + " of " + std::string(node.kind().word) + " is " + number_text(node.numbers[i]),
        .fix = "give " + std::string(bounds.meaning) + ", from " + number_text(bounds.least) + " to " +
               number_text(bounds.most),
        .number = i};
  }
  return std::nullopt;
}

}  // namespace

std::span<const Word> words() noexcept { return kWords; }

std::optional<std::size_t> find_word(std::string_view word) noexcept {
  for (std::size_t i = 0; i < std::size(kWords); ++i)
    if (kWords[i].word == word) return i;
  return std::nullopt;
}

std::optional<Complaint> complaint_about(const Node& node) {
  if (auto complaint = range_complaint(node)) return complaint;
  const std::string word(node.kind().word);
  if (const auto first = direction_of(node.kind())) {
    const std::size_t i = *first;
    if (!(std::hypot(node.numbers[i], node.numbers[i + 1], node.numbers[i + 2]) > 1e-9))
      return Complaint{
          .what = "the direction of " + word + " is zero", .fix = "give a direction such as 0 0 1", .number = i};
  }
  if (node.kind().op == Op::Arc) {
    const double sweep_deg = node.numbers[3] - node.numbers[2];
    if (!(sweep_deg >= 0.0 && sweep_deg <= 360.0))
      return Complaint{
          .what = word + " goes from " + number_text(node.numbers[2]) + " to " + number_text(node.numbers[3]) + " deg",
          .fix = "give to_deg a value from from_deg to from_deg + 360",
          .number = 3};
  }
  return std::nullopt;
}

std::size_t end_of(const Solid& solid, std::size_t node) noexcept {
  std::size_t missing = 1;
  while (missing > 0 && node < solid.size()) missing += static_cast<std::size_t>(solid[node++].kind().operands) - 1;
  return node;
}

}  // namespace telepalp::solids
