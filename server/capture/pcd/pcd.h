#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// An organised point cloud: one point a pixel, rows top to bottom; a point whose z is not finite is "not measured".
struct OrganisedCloud {
  int width = 0;
  int height = 0;
  std::vector<float> x;  ///< [m], one value a pixel, as for y and z
  std::vector<float> y;
  std::vector<float> z;
  std::vector<std::uint8_t> rgb;  ///< three bytes a pixel; empty when the file has no colour
};

/// The cloud in a PCD file's bytes: ascii, binary or binary_compressed. `name` stands for the file in errors. Every
/// size is checked against the bytes that are there before anything is allocated. A cloud that is not organised is
/// refused.
[[nodiscard]] Result<OrganisedCloud> parse_pcd(std::span<const std::byte> bytes, const std::string& name);

/// The same from a file of at most 512 MiB.
[[nodiscard]] Result<OrganisedCloud> read_pcd(const std::filesystem::path& file);

/// The cloud as the image that it came from: intrinsics fitted to where the points lie, depth in steps of 0.1 mm (1 mm
/// when some point is further than 6.5 m). `captured` and `sequence` are not set. Refused: points that no pinhole
/// camera put on the pixels that they stand for (RMS beyond 0.7 pixel).
[[nodiscard]] Result<RgbdFrame> frame_of(const OrganisedCloud& cloud, const std::string& name);

}  // namespace telepalp::server
