#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp::capture {

/// Record types of an .oni file, with the numbers of OpenNI's recorder.
enum class OniRecordKind : std::uint32_t {
  NodeAdded4 = 2,  ///< in format 1.0.0.4
  IntProperty = 3,
  RealProperty = 4,
  StringProperty = 5,
  GeneralProperty = 6,
  NodeRemoved = 7,
  NodeDataBegin = 8,
  NodeStateReady = 9,
  NewData = 10,
  End = 11,
  NodeAdded5 = 12,  ///< in format 1.0.0.5
  NodeAdded = 13,
  SeekTable = 14,
};

struct OniRecord {
  OniRecordKind kind{};
  std::uint32_t node = 0;           ///< number of the device or stream
  std::uint64_t at = 0;             ///< file offset of the record's first byte
  std::string fields;               ///< the bytes between the record's header and its payload
  std::uint64_t payload_at = 0;     ///< file offset of the payload's first byte
  std::uint32_t payload_bytes = 0;  ///< length of the payload, which lies within the file
};

/// Iterates over the records of an .oni file. Sizes are checked against the file's size before memory is allocated. A
/// damaged record is skipped up to the next "NIR\0", which begins each record. The time is linear in the file's size.
class OniRecordWalk {
 public:
  /// `file` must outlive the object. `name`: file name, for errors. Error: no .oni header of format 1.0.0.4 to 1.x.
  [[nodiscard]] static Result<OniRecordWalk> open(std::istream& file, const std::string& name);

  /// The next readable record; nullopt at the end record or at the end of the file.
  [[nodiscard]] std::optional<OniRecord> next();

  [[nodiscard]] bool reached_end_record() const noexcept { return reached_end_record_; }
  [[nodiscard]] std::uint64_t file_bytes() const noexcept { return file_bytes_; }
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }
  /// File offset of the first of the damaged() skipped parts; meaningless if damaged() is 0.
  [[nodiscard]] std::uint64_t first_damage_at() const noexcept { return first_damage_at_; }

 private:
  OniRecordWalk(std::istream& file, std::uint64_t file_bytes, bool offsets_of_32_bits)
      : file_(&file), file_bytes_(file_bytes), header_bytes_(offsets_of_32_bits ? 24 : 28) {}
  [[nodiscard]] std::optional<OniRecord> read_record();
  [[nodiscard]] bool find_mark();

  std::istream* file_;
  std::uint64_t file_bytes_;
  std::uint32_t header_bytes_;
  std::uint64_t at_ = 24;  // after the file's header
  bool reached_end_record_ = false;
  std::uint64_t damaged_ = 0;
  std::uint64_t first_damage_at_ = 0;
};

/// Reads `count` bytes at offset `at`; nullopt when the file ends before `at` + `count`.
[[nodiscard]] std::optional<std::string> read_at(std::istream& file, std::uint64_t at, std::uint32_t count);

}  // namespace telepalp::capture
