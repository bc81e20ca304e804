#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::models {

/// The content of a PCD, PLY or OBJ file that haptic rendering needs. Coordinates are in the unit and frame of the
/// file.
struct PointModel {
  std::vector<Eigen::Vector3f> points;                  ///< NaN in the holes of an organised cloud
  std::vector<Eigen::Vector3f> normals;                 ///< one per point, of any length; or empty
  std::vector<std::array<std::uint8_t, 3>> colors;      ///< RGB, one per point, or empty; only from PCD files
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points; empty: a cloud
  int width = 0;                                        ///< width of an organised cloud; 0: unorganised
};

inline constexpr std::size_t kMostModelPoints = 20'000'000;

/// Reads a file by its ending: .pcd (ascii, binary, binary_compressed), .ply (ascii, binary_little_endian), .obj. Of an
/// OBJ file with a group `body`, only that group is read, because the other groups of MakeHuman's files are helper
/// geometry. A vertex of an OBJ file gets the sum of its corners' normals. Declared sizes are checked against the
/// file's size before memory is allocated. Each error names the file and a fix.
[[nodiscard]] Result<PointModel> read_point_model(const std::filesystem::path& file);

/// Parsers of one format each. `name`: the file's name, for errors.
[[nodiscard]] Result<PointModel> parse_pcd(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<PointModel> parse_ply(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<PointModel> parse_obj(std::span<const std::byte> bytes, const std::string& name);

/// The error of a model whose size cannot be a patient's: its fix names each unit that gives a patient's size. nullopt
/// when the size is plausible: 2 mm to 12 m. `model`: in metres, after `unit_m` metres for one unit of the file were
/// applied. Error::where is empty.
[[nodiscard]] std::optional<Error> unit_error(const PointModel& model, double unit_m);

}  // namespace telepalp::models
