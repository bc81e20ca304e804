#include "server/capture/oni/record_walk.h"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "proto/words/little_endian.h"

namespace telepalp::capture {
namespace {

constexpr std::string_view kFileMark = "NI10";
constexpr std::string_view kRecordMark{"NIR\0", 4};
constexpr std::uint32_t kFileHeaderBytes = 24;
constexpr std::uint32_t kMostFieldBytes = 1U << 20U;  // the largest that OpenNI writes are tables of 20 KB
constexpr std::uint32_t kBlockBytes = 1U << 16U;

bool is_known(std::uint32_t kind) {
  return kind >= static_cast<std::uint32_t>(OniRecordKind::NodeAdded4) &&
         kind <= static_cast<std::uint32_t>(OniRecordKind::SeekTable);
}

std::uint64_t size_of(std::istream& file) {
  file.clear();
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  return size < 0 ? 0 : static_cast<std::uint64_t>(size);
}

}  // namespace

std::optional<std::string> read_at(std::istream& file, std::uint64_t at, std::uint32_t count) {
  std::string bytes(count, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  if (!file.read(bytes.data(), count)) return std::nullopt;
  return bytes;
}

Result<OniRecordWalk> OniRecordWalk::open(std::istream& file, const std::string& name) {
  const std::optional<std::string> mark = read_at(file, 0, kFileMark.size());
  if (mark != kFileMark)
    return Error{.what = "is not an .oni recording",
                 .where = name,
                 .fix = "give a recording made by OpenNI's recorder (NiViewer writes them)"};
  const std::optional<std::string> header = read_at(file, 0, kFileHeaderBytes);
  if (!header)
    return Error{.what = "cannot be played: it is cut off inside its header",
                 .where = name,
                 .fix = "copy the whole recording again"};
  const std::tuple version{
      get_little_endian<std::uint8_t>(header->data() + 4), get_little_endian<std::uint8_t>(header->data() + 5),
      get_little_endian<std::uint16_t>(header->data() + 6), get_little_endian<std::uint32_t>(header->data() + 8)};
  if (version < std::tuple{1, 0, 0, 4U} || std::get<0>(version) != 1)
    return Error{.what = "cannot be played: its header names a format version below 1.0.0.4, or 2.0 or later",
                 .where = name + ": byte 4",
                 .fix = "copy the whole recording again, or record again with OpenNI's recorder (NiViewer)"};
  const bool offsets_of_32_bits = version < std::tuple{1, 0, 1, 0U};
  return OniRecordWalk(file, size_of(file), offsets_of_32_bits);
}

std::optional<OniRecord> OniRecordWalk::read_record() {
  const std::optional<std::string> header = read_at(*file_, at_, header_bytes_);
  if (!header || !header->starts_with(kRecordMark)) return std::nullopt;
  const auto kind = get_little_endian<std::uint32_t>(header->data() + 4);
  const auto bytes_before_payload = get_little_endian<std::uint32_t>(header->data() + 12);
  OniRecord record{.kind = static_cast<OniRecordKind>(kind),
                   .node = get_little_endian<std::uint32_t>(header->data() + 8),
                   .at = at_,
                   .fields = {},
                   .payload_at = at_ + bytes_before_payload,
                   .payload_bytes = get_little_endian<std::uint32_t>(header->data() + 16)};
  if (!is_known(kind) || bytes_before_payload < header_bytes_ || bytes_before_payload > kMostFieldBytes ||
      record.payload_at + record.payload_bytes > file_bytes_)
    return std::nullopt;
  std::optional<std::string> fields = read_at(*file_, at_ + header_bytes_, bytes_before_payload - header_bytes_);
  if (!fields) return std::nullopt;
  record.fields = std::move(*fields);
  return record;
}

/// Moves to the next record mark after the damage; false if there is none.
bool OniRecordWalk::find_mark() {
  for (std::uint64_t from = at_ + 1; from + kRecordMark.size() <= file_bytes_;) {
    const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(kBlockBytes, file_bytes_ - from));
    const std::optional<std::string> block = read_at(*file_, from, count);
    if (!block) return false;
    if (const std::size_t mark = block->find(kRecordMark); mark != std::string::npos) {
      at_ = from + mark;
      return true;
    }
    from += count - (kRecordMark.size() - 1);  // the mark may extend over two blocks
  }
  return false;
}

std::optional<OniRecord> OniRecordWalk::next() {
  while (!reached_end_record_ && at_ < file_bytes_) {
    std::optional<OniRecord> record = read_record();
    if (!record) {
      if (damaged_++ == 0) first_damage_at_ = at_;
      if (!find_mark()) at_ = file_bytes_;
      continue;
    }
    at_ = record->payload_at + record->payload_bytes;
    reached_end_record_ = record->kind == OniRecordKind::End;
    if (!reached_end_record_) return record;
  }
  return std::nullopt;
}

}  // namespace telepalp::capture
