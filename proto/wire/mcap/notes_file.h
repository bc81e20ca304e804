#pragma once

#include <filesystem>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::wire {

constexpr int kMostNotes = 1000;  ///< largest number of notes on one session

/// The file of the notes on a session: SESSION.mcap.notes.json, in the session's folder.
[[nodiscard]] std::filesystem::path notes_file(const std::filesystem::path& session);

/// Reads the notes on `session`; without a file of notes the list is empty. Error: the file cannot be read, has more
/// than kMostNotes notes, or the time of a note in the session (`at_s`) is negative or not finite.
[[nodiscard]] Result<msg::SessionNotes> read_notes(const std::filesystem::path& session);

}  // namespace telepalp::wire
