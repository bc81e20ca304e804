#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "tools/study/protocol/protocol.h"

namespace telepalp::study {

/// What became of one attempt at a planned penetration.
enum class AttemptKind {
  Training,
  Formal,
  BrokenOff,  ///< the person let go before the puncture; the penetration is asked for again
};

[[nodiscard]] std::string_view name(AttemptKind kind) noexcept;

/// One row of a journal.
struct Attempt {
  AttemptKind kind = AttemptKind::Formal;
  Trial trial;             ///< its `person` is 0
  double held_up_s = 0.0;  ///< time that the simulation lost, because program or browser were late
};

/// What a journal's first lines say.
struct JournalHead {
  std::string identity;  ///< identity_of() the protocol
  std::string participant;
  PersonHand hand = PersonHand::Browser;
  [[nodiscard]] friend bool operator==(const JournalHead&, const JournalHead&) = default;
};

/// A journal as it was read.
struct JournalText {
  JournalHead head;
  std::vector<Attempt> attempts;
  std::size_t whole_bytes = 0;  ///< of the text up to the end of the last whole line
};

/// The first lines of a new journal, and one line of it. Each row begins with a checksum of the rest.
[[nodiscard]] std::string journal_begin(const JournalHead& head);
[[nodiscard]] std::string journal_line(const Attempt& attempt);
/// A last line without its end was being written when the program was killed: it does not count. Error: another line is
/// damaged, with `file:line:column`.
[[nodiscard]] Result<JournalText> parse_journal(std::string_view text, const std::string& file);

/// The number of planned penetrations that are done. Error: the rows are not those of the plan, with `file:line`.
[[nodiscard]] Result<std::size_t> done_of(const std::vector<Planned>& plan, const std::vector<Attempt>& attempts,
                                          const std::string& file);

/// The file of all attempts of one participant. Each row is on the disk before the next penetration begins, so a
/// program that was ended in any way goes on where it was.
class Journal {
 public:
  /// Opens or creates `file`. Error: it is damaged, or it is the journal of another protocol or participant.
  [[nodiscard]] static Result<Journal> open(const std::filesystem::path& file, const JournalHead& head);
  [[nodiscard]] const std::vector<Attempt>& attempts() const noexcept { return attempts_; }
  /// True: a row that was cut off has been removed.
  [[nodiscard]] bool repaired() const noexcept { return repaired_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  /// Error: the row could not be written, as on a full disk.
  [[nodiscard]] Result<void> add(const Attempt& attempt);

 private:
  std::filesystem::path file_;
  std::vector<Attempt> attempts_;
  bool repaired_ = false;
};

}  // namespace telepalp::study
