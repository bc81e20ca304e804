#include "codec/depth_codec.h"

#include <zstd.h>

#include <array>
#include <bit>
#include <cstring>

#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

static_assert(std::endian::native == std::endian::little, "samples and header fields are little-endian as they lie");

/// "TPD1" | width u32 | height u32 | unit_m f64 | zstd frame of the raw samples.
constexpr std::array<char, 4> kMagic{'T', 'P', 'D', '1'};
constexpr std::size_t kHeaderBytes = 20;
constexpr int kZstdLevel = 1;

Error damaged(std::string what) {
  return {.what = std::move(what), .where = "decode_depth", .fix = "send the frame again; check that both ends match"};
}

}  // namespace

std::string_view name(DepthMode) noexcept { return "fast"; }

std::string encode_depth(const DepthImage& depth, DepthMode) {
  demand(is_well_formed(depth), "encode_depth is given a well-formed image");
  const std::size_t raw_bytes = depth.samples.size() * sizeof(std::uint16_t);
  std::string packet(kHeaderBytes + ZSTD_compressBound(raw_bytes), '\0');
  const std::array<std::uint32_t, 2> sides{static_cast<std::uint32_t>(depth.width),
                                           static_cast<std::uint32_t>(depth.height)};
  std::memcpy(packet.data(), kMagic.data(), kMagic.size());
  std::memcpy(packet.data() + 4, sides.data(), sizeof sides);
  std::memcpy(packet.data() + 12, &depth.unit_m, sizeof depth.unit_m);
  const std::size_t bytes = ZSTD_compress(packet.data() + kHeaderBytes, packet.size() - kHeaderBytes,
                                          depth.samples.data(), raw_bytes, kZstdLevel);
  demand(ZSTD_isError(bytes) == 0, "zstd has room for its own bound");
  packet.resize(kHeaderBytes + bytes);
  return packet;
}

Result<DepthImage> decode_depth(std::span<const std::byte> packet) {
  if (packet.size() < kHeaderBytes || std::memcmp(packet.data(), kMagic.data(), kMagic.size()) != 0)
    return damaged("packet of " + std::to_string(packet.size()) + " B is no depth image");
  std::array<std::uint32_t, 2> sides{};
  DepthImage depth;
  std::memcpy(sides.data(), packet.data() + 4, sizeof sides);
  std::memcpy(&depth.unit_m, packet.data() + 12, sizeof depth.unit_m);
  if (sides[0] == 0 || sides[1] == 0 || sides[0] > kMaxImageSide || sides[1] > kMaxImageSide)
    return damaged("declares " + std::to_string(sides[0]) + " x " + std::to_string(sides[1]) + " pixels");
  depth.width = static_cast<int>(sides[0]);
  depth.height = static_cast<int>(sides[1]);
  depth.samples.resize(std::size_t{sides[0]} * sides[1]);
  const std::size_t raw_bytes = depth.samples.size() * sizeof(std::uint16_t);
  const std::size_t bytes =
      ZSTD_decompress(depth.samples.data(), raw_bytes, packet.data() + kHeaderBytes, packet.size() - kHeaderBytes);
  if (bytes != raw_bytes) return damaged("compressed samples are damaged or of another size");
  if (!is_well_formed(depth)) return damaged("depth unit is not a positive length");
  return depth;
}

}  // namespace telepalp::codec
