#include "proto/wire/mcap/format/record_walk.h"

#include "proto/wire/mcap/format/byte_cursor.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::size_t kVersionPlace = 5;  // place of the version's digit in the magic bytes

std::string at_byte(std::uint64_t offset) { return " (at byte " + std::to_string(offset) + ")"; }

}  // namespace

Error damaged(const ByteSource& source, std::string what) {
  return {.what = std::move(what), .where = source.name(), .fix = "telepalp-record repair " + source.name()};
}

Error damaged(const ByteSource& source, std::string what, std::uint64_t offset) {
  return damaged(source, std::move(what) + at_byte(offset));
}

Error refused(const ByteSource& source, std::string what, std::string fix) {
  return {.what = std::move(what), .where = source.name(), .fix = std::move(fix)};
}

Error unreadable(const ByteSource& source, std::uint64_t offset) {
  return refused(source, "cannot be read" + at_byte(offset),
                 "check the disk that holds the file, or copy the file again");
}

Error in_chunk(const ByteSource& source, std::uint64_t number, std::uint64_t offset, const Error& error) {
  const bool has_place = error.what.find("(at byte ") != std::string::npos;
  const std::string what = "chunk " + std::to_string(number) + ": " + error.what + (has_place ? "" : at_byte(offset));
  return error.fix.empty() ? damaged(source, what) : refused(source, what, error.fix);
}

Result<RecordHead> read_head(ByteSource& source, std::uint64_t offset, std::uint64_t end) {
  std::string bytes;
  if (offset > end || end > source.size() || end - offset < kRecordHeadBytes)
    return damaged(source, "truncated", offset);
  if (!source.read(offset, kRecordHeadBytes, bytes)) return unreadable(source, offset);
  ByteCursor from(bytes);
  const auto opcode = static_cast<Opcode>(from.u8());
  const RecordHead head{opcode, offset, from.u64()};
  if (head.length > end - offset - kRecordHeadBytes) return damaged(source, "truncated", offset);
  return head;
}

Result<void> read_content(ByteSource& source, const RecordHead& head, std::string& into) {
  if (head.length > kMaxRecordBytes)
    return refused(
        source,
        "a record of " + std::to_string(head.length) + " bytes is above the limit of 64 MiB" + at_byte(head.offset),
        "write the file again with chunks and attachments of at most 64 MiB");
  if (!source.read(head.content(), head.length, into)) return unreadable(source, head.offset);
  return {};
}

Result<void> check_magic(ByteSource& source) {
  std::string bytes;
  const bool long_enough = source.size() >= kMagic.size() && source.read(0, kMagic.size(), bytes);
  if (long_enough && bytes == kMagic) return {};
  if (long_enough && bytes.starts_with(kMagic.substr(0, kVersionPlace)) && bytes.ends_with("\r\n"))
    return refused(source, std::string("is of MCAP version ") + bytes[kVersionPlace] + "; only version 0 can be read",
                   "write the file again as MCAP version 0");
  return refused(source, source.size() == 0 ? "is empty" : "is not an MCAP file", "give a session file (.mcap)");
}

}  // namespace telepalp::wire::mcap
