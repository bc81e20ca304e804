#include "proto/wire/mcap/format/record_walk.h"

#include "proto/wire/mcap/format/byte_cursor.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::uint64_t kMaxRecordBytes = kMaxChunkBytes + 4096;

}  // namespace

Error damaged(const ByteSource& source, std::string what) {
  return {.what = std::move(what), .where = source.name(), .fix = "telepalp-record --repair " + source.name()};
}

Error refused(const ByteSource& source, std::string what, std::string fix) {
  return {.what = std::move(what), .where = source.name(), .fix = std::move(fix)};
}

Error in_chunk(const ByteSource& source, std::uint64_t number, const Error& error) {
  const std::string what = "chunk " + std::to_string(number) + ": " + error.what;
  return error.fix.empty() ? damaged(source, what) : refused(source, what, error.fix);
}

Result<RecordHead> read_head(ByteSource& source, std::uint64_t offset, std::uint64_t end) {
  std::string bytes;
  if (offset > end || end > source.size() || end - offset < kRecordHeadBytes) return damaged(source, "truncated");
  if (!source.read(offset, kRecordHeadBytes, bytes)) return damaged(source, "cannot be read");
  ByteCursor from(bytes);
  const auto opcode = static_cast<Opcode>(from.u8());
  const RecordHead head{opcode, offset, from.u64()};
  if (head.length > end - offset - kRecordHeadBytes) return damaged(source, "truncated");
  return head;
}

Result<void> read_content(ByteSource& source, const RecordHead& head, std::string& into) {
  if (head.length > kMaxRecordBytes)
    return refused(source, "a record of " + std::to_string(head.length) + " bytes is above the limit of 64 MiB",
                   "write the file again with smaller chunks");
  if (!source.read(head.content(), head.length, into)) return damaged(source, "cannot be read");
  return {};
}

Result<void> check_magic(ByteSource& source) {
  std::string bytes;
  if (source.size() >= kMagic.size() && source.read(0, kMagic.size(), bytes) && bytes == kMagic) return {};
  return refused(source, source.size() == 0 ? "is empty" : "is not an MCAP file", "give a session file (.mcap)");
}

}  // namespace telepalp::wire::mcap
