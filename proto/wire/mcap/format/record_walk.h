#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/records.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// No chunk may declare more than this, unpacked, and no record that is read whole may be larger: what a hostile
/// file can make a reader allocate. telepalp's own chunks hold 1 MiB and at most one message more.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{64} << 20;

struct RecordHead {
  Opcode opcode{};
  std::uint64_t offset = 0;  // of the head
  std::uint64_t length = 0;  // of the content
  [[nodiscard]] std::uint64_t content() const noexcept { return offset + kRecordHeadBytes; }
  [[nodiscard]] std::uint64_t end() const noexcept { return content() + length; }
};

/// An error in `source` that a repair gets around.
[[nodiscard]] Error damaged(const ByteSource& source, std::string what);
/// An error in `source` that a repair does not get around.
[[nodiscard]] Error refused(const ByteSource& source, std::string what, std::string fix);

/// The head at `offset`; an error if it, or the content it declares, reaches past `end`.
[[nodiscard]] Result<RecordHead> read_head(ByteSource& source, std::uint64_t offset, std::uint64_t end);

/// The content of a record, no larger than kMaxChunkBytes and a little.
[[nodiscard]] Result<void> read_content(ByteSource& source, const RecordHead& head, std::string& into);

/// An error unless `source` starts as an MCAP file does.
[[nodiscard]] Result<void> check_magic(ByteSource& source);

/// `error`, which names no file, told of chunk `number` of `source`: "session.mcap: chunk 812: truncated".
[[nodiscard]] Error in_chunk(const ByteSource& source, std::uint64_t number, const Error& error);

}  // namespace telepalp::wire::mcap
