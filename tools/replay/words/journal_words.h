#pragma once

#include <optional>
#include <string>

#include "haptic_station/core/journal/journal_replay.h"
#include "messages/journal.pb.h"

namespace telepalp::replay {

/// A journal that has been read.
struct ReadJournal {
  std::string file;
  msg::JournalHeader header;
  std::optional<msg::JournalEnd> end;  ///< nullopt: the journal was cut off, or is damaged
  std::uint64_t whole_bytes = 0;       ///< up to the last whole block
};

/// The program and the machine that computed a journal again.
struct Here {
  std::string build;      ///< as build_of()
  std::string processor;  ///< its model
};
[[nodiscard]] std::string build_of(const std::string& version, const std::string& commit);

/// The verdict for a person: counts of ticks that differ, why the replay stopped, and what limits the comparison, each
/// with a fix.
[[nodiscard]] std::string in_words(const ReadJournal& journal, const core::JournalVerdict& verdict, const Here& here);

}  // namespace telepalp::replay
