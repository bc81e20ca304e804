#include "proto/wire/mcap/reading/chunk_search.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/byte_cursor.h"
#include "proto/wire/mcap/format/record_walk.h"

namespace telepalp::wire::mcap {
namespace {

// The window is small, because the next chunk is usually near, and a file may have many damaged places.
constexpr std::uint64_t kFirstWindowBytes = std::uint64_t{1} << 10;
constexpr std::uint64_t kLargestWindowBytes = std::uint64_t{1} << 20;
constexpr std::uint64_t kFixedHeaderBytes = 8 + 8 + 8 + 4 + 4 + 8;  // of a chunk without the name of its compression
constexpr std::uint64_t kLongestName = 4;
constexpr std::uint64_t kNeededBytes = kRecordHeadBytes + kFixedHeaderBytes + kLongestName;

bool is_compression(std::string_view name) { return name.empty() || name == "zstd" || name == "lz4"; }

/// `bytes`: the head of a record and the start of its content. `left`: bytes from the head to the end of the file.
bool begins_a_chunk(std::string_view bytes, std::uint64_t left) {
  ByteCursor from(bytes);
  if (static_cast<Opcode>(from.u8()) != Opcode::Chunk) return false;
  const std::uint64_t length = from.u64();
  if (length < kFixedHeaderBytes || length > kMaxRecordBytes || length > left - kRecordHeadBytes) return false;
  const std::uint64_t start = from.u64();
  const std::uint64_t end = from.u64();
  const std::uint64_t unpacked = from.u64();
  (void)from.u32();  // the CRC is checked when the chunk is read
  const std::string_view compression = from.text();
  const std::uint64_t records = from.u64();
  return from.ok() && start <= end && unpacked <= kMaxChunkBytes && is_compression(compression) &&
         records == length - kFixedHeaderBytes - compression.size();
}

}  // namespace

std::optional<std::uint64_t> find_chunk(ByteSource& source, std::uint64_t from) {
  std::string window;
  std::uint64_t window_bytes = kFirstWindowBytes;
  for (std::uint64_t at = source.next_data(from); at < source.size(); at = source.next_data(at)) {
    const std::uint64_t length = std::min(window_bytes, source.size() - at);
    if (length < kRecordHeadBytes + kFixedHeaderBytes || !source.read(at, length, window)) return std::nullopt;
    const bool is_last = at + length == source.size();
    const std::size_t places = is_last ? window.size() : window.size() - kNeededBytes;
    for (std::size_t place = window.find('\x06'); place < places; place = window.find('\x06', place + 1))
      if (begins_a_chunk(std::string_view(window).substr(place, kNeededBytes), source.size() - at - place))
        return at + place;
    if (is_last) return std::nullopt;
    at += places;
    window_bytes = std::min(4 * window_bytes, kLargestWindowBytes);
  }
  return std::nullopt;
}

bool ends_within_record(ByteSource& source, std::uint64_t offset) {
  const std::uint64_t left = source.size() - offset;
  std::string bytes;
  if (left == 0) return true;
  if (!source.read(offset, std::min(left, kNeededBytes), bytes)) return false;
  ByteCursor from(bytes);
  const auto opcode = static_cast<Opcode>(from.u8());
  if (opcode < Opcode::Header || opcode > Opcode::DataEnd) return false;
  if (left < kRecordHeadBytes) return true;
  const std::uint64_t length = from.u64();
  if (length > kMaxRecordBytes || length <= left - kRecordHeadBytes) return false;
  return opcode != Opcode::Chunk || left < kNeededBytes || begins_a_chunk(bytes, UINT64_MAX);
}

}  // namespace telepalp::wire::mcap
