#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::models {

/// What a PCD, PLY or OBJ file holds, as far as touch is concerned; coordinates as they stand in the file.
struct PointModel {
  std::vector<Eigen::Vector3f> points;              ///< not finite where an organised cloud has a hole
  std::vector<Eigen::Vector3f> normals;             ///< one a point, or none at all
  std::vector<std::array<std::uint8_t, 3>> colors;  ///< red, green, blue: of a PCD alone, one a point, or none at all
  std::vector<std::array<std::uint32_t, 3>> triangles;
  int width = 0;  ///< of an organised cloud; 0: unorganised
};

inline constexpr std::size_t kMostModelPoints = 20'000'000;

/// Reads a file by its ending: .pcd (ascii, binary, binary_compressed), .ply (ascii, binary_little_endian), .obj. An
/// OBJ with a group `body` is only that group: MakeHuman's other groups are helpers. A vertex of an OBJ whose corners
/// have several normals gets their mean. Sizes are checked against the
/// bytes that are there before anything is allocated; every error names the file and what to do.
[[nodiscard]] Result<PointModel> read_point_model(const std::filesystem::path& file);

/// The parts of read_point_model; `name` stands for the file in errors.
[[nodiscard]] Result<PointModel> parse_pcd(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<PointModel> parse_ply(std::span<const std::byte> bytes, const std::string& name);
[[nodiscard]] Result<PointModel> parse_obj(std::span<const std::byte> bytes, const std::string& name);

/// A reason to believe that the coordinates are not metres, with the unit that fits a patient; empty when plausible.
[[nodiscard]] std::string unit_complaint(const PointModel& model);
inline constexpr const char* kSayTheUnit = "say the unit of the file's coordinates: --unit-m, or unit_m in a scene";

}  // namespace telepalp::models
