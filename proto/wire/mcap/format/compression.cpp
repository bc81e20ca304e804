#include "proto/wire/mcap/format/compression.h"

#include <zlib.h>
#include <zstd.h>

#include "proto/words/demand.h"

namespace telepalp::wire::mcap {

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) noexcept {
  return static_cast<std::uint32_t>(::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string zstd_compress(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1);
  demand(ZSTD_isError(size) == 0, "zstd compresses into a buffer of its own bound");
  out.resize(size);
  return out;
}

std::optional<std::string> zstd_decompress(std::string_view bytes, std::size_t size) {
  std::string out(size, '\0');
  const std::size_t written = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0 || written != size) return std::nullopt;
  return out;
}

}  // namespace telepalp::wire::mcap
