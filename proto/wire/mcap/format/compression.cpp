#include "proto/wire/mcap/format/compression.h"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <memory>

#include "proto/words/demand.h"

namespace telepalp::wire::mcap {

std::uint32_t crc32(std::string_view bytes, std::uint32_t before) noexcept {
  return static_cast<std::uint32_t>(::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string zstd_compress(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1);
  demand(ZSTD_isError(size) == 0, "zstd compresses a chunk without an error");
  out.resize(size);
  return out;
}

std::optional<std::string> zstd_decompress(std::string_view bytes, std::size_t size) {
  std::string out(size, '\0');
  const std::size_t written = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0 || written != size) return std::nullopt;
  return out;
}

std::optional<std::string> lz4_decompress(std::string_view bytes, std::size_t size) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0) return std::nullopt;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(raw,
                                                                                     &LZ4F_freeDecompressionContext);
  std::string out(size, '\0');
  std::size_t written = 0;
  for (;;) {
    std::size_t room = size - written, consumed = bytes.size();
    const std::size_t wanted =
        LZ4F_decompress(context.get(), out.data() + written, &room, bytes.data(), &consumed, nullptr);
    if (LZ4F_isError(wanted) != 0) return std::nullopt;
    written += room;
    bytes.remove_prefix(consumed);
    const bool frame_ended = wanted == 0;
    if (frame_ended && bytes.empty() && written == size) return out;
    if (frame_ended || (room == 0 && consumed == 0)) return std::nullopt;
  }
}

}  // namespace telepalp::wire::mcap
