#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::wire {

constexpr int kMostNotes = 1000;  ///< largest number of notes on one session
constexpr std::size_t kMostNoteText_B = 500;

/// What is wrong with the text of a note, as the end of a sentence; empty: it is one line, and not too long.
[[nodiscard]] std::string_view fault_of_note(std::string_view text) noexcept;

/// The file of the notes on a session: SESSION.mcap.notes.json, in the session's folder. It is encrypted as the session
/// is (mcap::text_beside()).
[[nodiscard]] std::filesystem::path notes_file(const std::filesystem::path& session);

/// A note that was made while a session took place.
struct ToldNote {
  double at_s = 0.0;  ///< since the session's beginning; not negative
  msg::LiveNote note{};
};

/// The messages of /session/notes of `session`, in order of at_s: at most kMostNotes. Damaged ones are left out. Error:
/// it is not a session file.
[[nodiscard]] Result<std::vector<ToldNote>> told_notes(const std::filesystem::path& session);

/// The same as notes on the session.
[[nodiscard]] msg::SessionNotes as_session_notes(const std::vector<ToldNote>& told);
[[nodiscard]] Result<msg::SessionNotes> live_notes(const std::filesystem::path& session);

/// The JSON in the file of notes on `session`, decrypted; nullopt: there is no such file. Error: it cannot be read or
/// decrypted, or is larger than kMostNotes of the longest notes need.
[[nodiscard]] Result<std::optional<std::string>> notes_text(const std::filesystem::path& session);

/// Reads the notes on `session`; without a file of notes they are `live`. Error: as notes_text(), or the file is
/// damaged, has more than kMostNotes notes, or the time of a note in the session (`at_s`) is negative or not finite.
[[nodiscard]] Result<msg::SessionNotes> read_notes(const std::filesystem::path& session, msg::SessionNotes live);

}  // namespace telepalp::wire
