#include "codec/bytes/zstd_stream.h"

#include <zstd.h>

#include <memory>

#include "proto/words/demand.h"

namespace telepalp::codec {
namespace {

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const noexcept { ZSTD_freeCCtx(context); }
};

void set(ZSTD_CCtx* context, ZSTD_cParameter parameter, int value) {
  demand(ZSTD_isError(ZSTD_CCtx_setParameter(context, parameter, value)) == 0,
         "zstd accepts the compression parameter");
}

}  // namespace

void append_zstd_stream(std::string& packet, std::string_view plain, ZstdEffort effort) {
  append_varint(packet, static_cast<std::uint32_t>(plain.size()));
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  demand(context != nullptr, "there is enough memory for a zstd context");
  set(context.get(), ZSTD_c_compressionLevel, 1);
  if (effort == ZstdEffort::Entropy) {  // small table, long minimum match: only Huffman coding works
    set(context.get(), ZSTD_c_hashLog, 6);
    set(context.get(), ZSTD_c_minMatch, 7);
  }
  std::string compressed(ZSTD_compressBound(plain.size()), '\0');
  const std::size_t bytes =
      ZSTD_compress2(context.get(), compressed.data(), compressed.size(), plain.data(), plain.size());
  demand(ZSTD_isError(bytes) == 0, "zstd compresses into a buffer of ZSTD_compressBound() bytes");
  const bool smaller = bytes < plain.size();
  append_varint(packet, smaller ? static_cast<std::uint32_t>(bytes) : 0);
  packet.append(smaller ? std::string_view(compressed.data(), bytes) : plain);
}

std::optional<std::string> read_zstd_stream(ByteReader& reader, std::size_t most_bytes) {
  const std::optional<std::uint32_t> size = reader.varint();
  const std::optional<std::uint32_t> compressed_size = reader.varint();
  if (!size || !compressed_size || *size > most_bytes) return std::nullopt;
  const auto bytes = reader.take(*compressed_size == 0 ? *size : *compressed_size);
  if (!bytes) return std::nullopt;
  if (*compressed_size == 0) return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  std::string plain(*size, '\0');
  const std::size_t got = ZSTD_decompress(plain.data(), plain.size(), bytes->data(), bytes->size());
  if (got != plain.size()) return std::nullopt;
  return plain;
}

}  // namespace telepalp::codec
