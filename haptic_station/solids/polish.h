#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "haptic_station/solids/solid.h"

namespace telepalp::solids {

/// Returns the distance lattice of a mesh. `file`: the file name as written in the Polish notation; `unit_m`: metres
/// for one unit of the file; `cell_m`: node spacing of the lattice [m].
using MeshReader = std::function<Result<std::shared_ptr<const DistanceLattice>>(const std::string& file, double unit_m,
                                                                                double cell_m)>;
/// A reader that refuses each mesh, for text that contains no mesh.
[[nodiscard]] Result<std::shared_ptr<const DistanceLattice>> no_meshes(const std::string& file, double, double);

inline constexpr std::size_t kMostPolishBytes = std::size_t{4} << 20;

/// Reads the Polish notation of paper S2 (docs/sources.md): an operator stands before its operands, words are separated
/// by space or lines, and `#` begins a comment. `tr x y z S` moves a solid, `tx x y z deg ax ay az S` turns the solid
/// by deg degrees about the axis (ax, ay, az) through the origin and then moves it, `torusx R r` is a torus about the x
/// axis, `+ A B` is the union of two solids (S2 III.A). docs/scenes.md lists all words. `tm` with twelve numbers, a 3
/// by 4 matrix row by row, is read as a motion `tx` and a uniform scaling `sc`; a matrix that shears or mirrors is
/// refused. Numbers have a decimal point in every locale.
/// Error: an unknown word, a missing operand, a number out of its range, a mesh that cannot be read, more than
/// 200 000 nodes (kMostNodes) or 100 nested operators (kMostNesting), or text longer than kMostPolishBytes. The error
/// states `name:line:column`, what was found, what was expected and how to fix it. `name`: the text's name in errors.
[[nodiscard]] Result<Solid> parse_polish(std::string_view text, const std::string& name,
                                         const MeshReader& meshes = no_meshes);

/// Reads a file in Polish notation. A file over kMostPolishBytes is refused before it is read.
[[nodiscard]] Result<Solid> read_polish(const std::filesystem::path& file, const MeshReader& meshes = no_meshes);

/// The solid in Polish notation on one line. Reading it again gives the same nodes.
[[nodiscard]] std::string to_polish(const Solid& solid);

}  // namespace telepalp::solids
