#include "proto/wire/mcap/format/chunk.h"

#include "proto/wire/mcap/format/byte_cursor.h"
#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/format/record_walk.h"

namespace telepalp::wire::mcap {
namespace {

Error what(std::string text) { return {.what = std::move(text), .where = {}, .fix = {}}; }

}  // namespace

Result<std::string> unpack(const ChunkRecord& chunk) {
  if (chunk.uncompressed_size > kMaxChunkBytes)
    return what("declares " + std::to_string(chunk.uncompressed_size) +
                " bytes after decompression; the limit is 64 MiB");
  std::string records;
  if (chunk.compression.empty()) {
    if (chunk.records.size() != chunk.uncompressed_size) return what("its size differs from the size that it declares");
    records = chunk.records;
  } else if (chunk.compression == "zstd" || chunk.compression == "lz4") {
    const auto decompress = chunk.compression == "zstd" ? zstd_decompress : lz4_decompress;
    std::optional<std::string> unpacked = decompress(chunk.records, chunk.uncompressed_size);
    if (!unpacked) return what("its " + std::string(chunk.compression) + " data is damaged");
    records = *std::move(unpacked);
  } else {
    return Error{
        .what = "is compressed with " + std::string(chunk.compression.substr(0, 32)) + ", which telepalp cannot read",
        .where = {},
        .fix = "write the file again with zstd, with lz4 or without compression"};
  }
  if (chunk.uncompressed_crc != 0 && chunk.uncompressed_crc != crc32(records))
    return what("its CRC does not match its data");
  return records;
}

Result<std::optional<ChunkWalk::Entry>> ChunkWalk::next() {
  if (rest_.empty()) return std::optional<Entry>{};
  ByteCursor from(rest_);
  const auto opcode = static_cast<Opcode>(from.u8());
  const std::string_view content = from.raw(from.u64());
  if (!from.ok()) return what("a record reaches past the end of the chunk");
  const bool allowed = opcode == Opcode::Schema || opcode == Opcode::Channel || opcode == Opcode::Message ||
                       opcode > Opcode::DataEnd;  // an unknown record is skipped, as the specification requires
  if (!allowed) return what("has a record of a type that is not allowed in a chunk");
  rest_ = from.rest();
  return std::optional<Entry>{{opcode, content}};
}

}  // namespace telepalp::wire::mcap
