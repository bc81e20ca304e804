#pragma once

#include <cstddef>
#include <string_view>

namespace telepalp::program {

/// Line and column in a text, both from 1. Columns count bytes.
struct TextPlace {
  int line;
  int column;
};

/// Offset in bytes of a line and column of a text-format file, as Protobuf's parser counts them: both from 0, a tab
/// ends at the next multiple of eight columns.
[[nodiscard]] std::size_t byte_of(std::string_view source, int line, int column) noexcept;

/// The place of byte `offset`, from 0, of the quoted text whose first quote is the first at or after byte `from` of
/// `source`; an escape such as \n is one byte. The text may consist of several quoted parts with spaces, lines and
/// comments between them. An offset beyond the text gives the text's end.
[[nodiscard]] TextPlace place_in_quoted(std::string_view source, std::size_t from, std::size_t offset) noexcept;

/// The place of the byte at offset `byte` of `source`.
[[nodiscard]] TextPlace place_of(std::string_view source, std::size_t byte) noexcept;

/// Length in bytes of the longest beginning of `text` that is valid UTF-8 (RFC 3629).
[[nodiscard]] std::size_t valid_utf8_bytes(std::string_view text) noexcept;

}  // namespace telepalp::program
