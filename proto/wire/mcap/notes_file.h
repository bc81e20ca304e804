#pragma once

#include <filesystem>
#include <string_view>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::wire {

constexpr int kMostNotes = 1000;  ///< largest number of notes on one session
constexpr std::size_t kMostNoteText_B = 500;

/// What is wrong with the text of a note, as the end of a sentence; empty: it is one line, and not too long.
[[nodiscard]] std::string_view fault_of_note(std::string_view text) noexcept;

/// The file of the notes on a session: SESSION.mcap.notes.json, in the session's folder.
[[nodiscard]] std::filesystem::path notes_file(const std::filesystem::path& session);

/// The notes that were made while `session` took place: its messages of /session/notes. Error: it is not a session
/// file.
[[nodiscard]] Result<msg::SessionNotes> live_notes(const std::filesystem::path& session);

/// Reads the notes on `session`; without a file of notes they are `live`. Error: the file cannot be read, has more than
/// kMostNotes notes, or the time of a note in the session (`at_s`) is negative or not finite.
[[nodiscard]] Result<msg::SessionNotes> read_notes(const std::filesystem::path& session, msg::SessionNotes live);

}  // namespace telepalp::wire
