#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "messages/playback.pb.h"
#include "proto/words/result.h"

namespace telepalp::playback {

/// The notes that people wrote on moments of a session: at most wire::kMostNotes. They are kept in the file
/// SESSION.mcap.notes.json, encrypted if the session is, which is replaced as a whole with each change. Owner: the
/// network thread, which waits at each change until the file is on the disk.
class SessionNotes {
 public:
  /// Reads the notes on `session`. `duration_s`: the session's length. `live`: wire::live_notes(), with which the list
  /// begins if nobody has written or removed a note yet. Error: the notes file cannot be read or decrypted, has too
  /// many notes, or a note with an impossible time; it is not changed then.
  [[nodiscard]] static Result<SessionNotes> open(const std::filesystem::path& session, double duration_s,
                                                 msg::SessionNotes live);

  /// Carries out the JSON of a msg::NoteCommand, and writes the file. A command without fields changes nothing. `who`:
  /// the writer. `now`: the date of the note. Error: the command is wrong, or the file cannot be written; the notes are
  /// then as before.
  [[nodiscard]] Result<void> apply(const std::string& json, const std::string& who,
                                   std::chrono::system_clock::time_point now);
  [[nodiscard]] const msg::SessionNotes& all() const noexcept { return notes_; }

 private:
  SessionNotes(std::filesystem::path session, double duration_s, msg::SessionNotes notes);
  [[nodiscard]] Result<void> check(const msg::NoteCommand& command) const;
  [[nodiscard]] Result<void> store(const msg::SessionNotes& changed) const;

  std::filesystem::path session_;
  double duration_s_;
  msg::SessionNotes notes_;
};

}  // namespace telepalp::playback
