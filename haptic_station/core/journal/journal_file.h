#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "messages/journal.pb.h"
#include "proto/words/result.h"

namespace telepalp::core {

/// Writes the blocks of a journal (proto/messages/journal.proto) to a stream, which must outlive this object. Owner:
/// one thread.
class JournalWriter {
 public:
  JournalWriter(std::ostream& out, const msg::JournalHeader& header);
  void add(const msg::JournalBlock& block);

 private:
  std::ostream& out_;
};

/// Reads the blocks of a journal from a stream, which must outlive this object.
class JournalReader {
 public:
  /// Reads the header. `name`: the file, for errors. Error: it is no journal, or one of a newer version.
  [[nodiscard]] static Result<JournalReader> open(std::istream& in, const std::string& name);

  [[nodiscard]] const msg::JournalHeader& header() const noexcept { return header_; }
  /// The next whole block; nullopt at the end.
  [[nodiscard]] std::optional<msg::JournalBlock> next();
  /// Once next() has returned nullopt: what the station wrote at its end; nullopt: the journal was cut off, or is
  /// damaged behind the last block.
  [[nodiscard]] const std::optional<msg::JournalEnd>& end() const noexcept { return end_; }
  [[nodiscard]] std::uint64_t whole_bytes() const noexcept { return whole_bytes_; }  ///< up to the last whole block

 private:
  explicit JournalReader(std::istream& in) : in_(&in) {}
  std::istream* in_;
  msg::JournalHeader header_;
  std::optional<msg::JournalEnd> end_;
  std::uint64_t whole_bytes_ = 0;
};

}  // namespace telepalp::core
