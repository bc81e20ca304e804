#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptic_station/solids/distance_lattice.h"
#include "proto/words/result.h"

namespace telepalp::solids {

/// What a node of a solid's description is: a shape, or an operator on one or two solids.
enum class Op : std::uint8_t {
  Sphere,
  Plane,
  Capsule,
  Torus,
  Arc,
  Box,
  Ellipsoid,
  Cylinder,
  Mesh,
  Union,
  Intersection,
  Difference,
  Blend,
  Clip,
  Translate,
  Transform,
  Rotate,
  Scale,
};

/// What a number after a word of the Polish notation stands for; it decides the number's allowed range.
enum class Unit : std::uint8_t { Coordinate, Length, Direction, Degrees, Factor };

struct NumberKind {
  std::string_view name;  ///< with its unit, as in the scene's text format: `radius_m`
  Unit unit;
};

/// A word of the Polish notation of paper S2 (docs/sources.md). `text_name`: its name in scene files, such as `union`
/// for `+`.
struct Word {
  std::string_view word;
  std::string_view text_name;
  Op op;
  int axis;  ///< of torus, arc and cylinder: 0 x, 1 y, 2 z
  int operands;
  std::span<const NumberKind> numbers;
};
[[nodiscard]] std::span<const Word> words() noexcept;

/// A node. `word`: index in words(). `numbers`: in the order of Word::numbers. `file`, `lattice`: of a mesh only.
struct Node {
  std::size_t word = 0;
  std::array<double, 7> numbers{};
  std::string file{};
  std::shared_ptr<const DistanceLattice> lattice{};  // shared: solids and trees keep it alive

  [[nodiscard]] const Word& kind() const noexcept { return words()[word]; }
  [[nodiscard]] bool operator==(const Node& other) const noexcept {
    return word == other.word && numbers == other.numbers && file == other.file;
  }
};

/// A solid as its nodes in prefix order: each operator is followed by its operands. Lengths are metres, in the frame
/// in which the solid is described.
using Solid = std::vector<Node>;

inline constexpr std::size_t kMostNodes = 200'000;
inline constexpr int kMostNesting = 100;  ///< depth of nested operators; the last operand of a union adds no depth

/// What is wrong with a node's numbers, and how to fix it. `what` names the number and its value.
struct Complaint {
  std::string what;
  std::string fix;
  std::size_t number = 0;  ///< index in Node::numbers
};
/// The first fault of the node's numbers; nullopt: all are valid.
[[nodiscard]] std::optional<Complaint> complaint_about(const Node& node);

/// The index of the word in words(); nullopt: unknown.
[[nodiscard]] std::optional<std::size_t> find_word(std::string_view word) noexcept;

/// One past the last node of the operand that starts at `node`.
[[nodiscard]] std::size_t end_of(const Solid& solid, std::size_t node) noexcept;

}  // namespace telepalp::solids
