#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/records.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Upper limit of a chunk's declared decompressed size. With kMaxRecordBytes it bounds the allocations that a malicious
/// file can cause. telepalp's own chunks hold 1 MiB plus at most one message.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{64} << 20;

/// Upper limit of a record's content that is read into memory: an uncompressed chunk of kMaxChunkBytes and its header.
inline constexpr std::uint64_t kMaxRecordBytes = kMaxChunkBytes + 4096;

struct RecordHead {
  Opcode opcode{};
  std::uint64_t offset = 0;  // offset of the record's head in the file
  std::uint64_t length = 0;  // of the record's content [B]
  [[nodiscard]] std::uint64_t content() const noexcept { return offset + kRecordHeadBytes; }
  [[nodiscard]] std::uint64_t end() const noexcept { return content() + length; }
};

/// An error about damage in `source` that `telepalp-record repair` can skip. `offset`: where the damage lies in the
/// file.
[[nodiscard]] Error damaged(const ByteSource& source, std::string what);
[[nodiscard]] Error damaged(const ByteSource& source, std::string what, std::uint64_t offset);
/// An error about `source` that a repair cannot solve.
[[nodiscard]] Error refused(const ByteSource& source, std::string what, std::string fix);
/// An error about bytes at `offset` in the file that the operating system does not deliver.
[[nodiscard]] Error unreadable(const ByteSource& source, std::uint64_t offset);

/// Reads the record head at `offset`. Error: the head or its declared content reaches past `end`.
[[nodiscard]] Result<RecordHead> read_head(ByteSource& source, std::uint64_t offset, std::uint64_t end);

/// Reads the content of a record. Error: it is larger than kMaxRecordBytes, or cannot be read.
[[nodiscard]] Result<void> read_content(ByteSource& source, const RecordHead& head, std::string& into);

/// Error: `source` does not start with the magic bytes of MCAP version 0.
[[nodiscard]] Result<void> check_magic(ByteSource& source);

/// Adds the file's name and the chunk's number and offset to `error`: "session.mcap: chunk 812: truncated (at byte
/// 90210)".
[[nodiscard]] Error in_chunk(const ByteSource& source, std::uint64_t number, std::uint64_t offset, const Error& error);

}  // namespace telepalp::wire::mcap
