#include "server/playback/session_notes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "proto/wire/mcap/format/place.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "proto/words/numbers/utc_text.h"
#include "support/program/files/whole_file.h"
#include "support/program/message_json.h"

namespace telepalp::playback {
namespace {

constexpr const char* kNotesExample =
    "send JSON such as {\"at_s\": 12.5, \"text\": \"rebound here\"} or {\"remove\": 3}";

Error wrong(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "playback/notes", .fix = std::move(fix)};
}

void insert(msg::SessionNotes& notes, msg::SessionNotes::Note note) {
  *notes.add_notes() = std::move(note);
  for (int at = notes.notes_size() - 1; at > 0 && notes.notes(at).at_s() < notes.notes(at - 1).at_s(); --at)
    notes.mutable_notes()->SwapElements(at, at - 1);
}

std::optional<int> place_of(const msg::SessionNotes& notes, std::uint64_t number) {
  for (int at = 0; at < notes.notes_size(); ++at)
    if (notes.notes(at).number() == number) return at;
  return std::nullopt;
}

}  // namespace

Result<SessionNotes> SessionNotes::open(const std::filesystem::path& session, double duration_s,
                                        msg::SessionNotes live) {
  Result<msg::SessionNotes> notes = wire::read_notes(session, std::move(live));
  if (!notes) return notes.error();
  return SessionNotes(session, duration_s, std::move(*notes));
}

SessionNotes::SessionNotes(std::filesystem::path session, double duration_s, msg::SessionNotes notes)
    : session_(std::move(session)), duration_s_(duration_s), notes_(std::move(notes)) {}

Result<void> SessionNotes::check(const msg::NoteCommand& command) const {
  if (command.has_remove() && !place_of(notes_, command.remove()))
    return wrong("no note has the number " + std::to_string(command.remove()),
                 "send a number that GET /playback/notes lists");
  if (command.has_at_s() != command.has_text()) return wrong("a note needs both at_s and text", kNotesExample);
  if (!command.has_at_s()) return {};
  if (!(command.at_s() >= 0.0 && command.at_s() <= duration_s_))
    return wrong("at_s is not from 0 to the session's end, " + std::to_string(duration_s_) + " s",
                 "send a time in the session");
  if (command.text().empty()) return wrong("text is empty", "send one line of at most 500 bytes");
  if (const std::string_view fault = wire::fault_of_note(command.text()); !fault.empty())
    return wrong(std::string(fault), "send one line of at most 500 bytes");
  if (notes_.notes_size() >= wire::kMostNotes)
    return wrong("the session has 1000 notes, as many as it may have", "remove a note first");
  return {};
}

Result<void> SessionNotes::apply(const std::string& json, const std::string& who,
                                 std::chrono::system_clock::time_point now) {
  msg::NoteCommand command;
  if (const Result<void> read = program::read_json(json, command, "playback/notes", kNotesExample); !read)
    return read.error();
  if (const Result<void> checked = check(command); !checked) return checked.error();
  if (!command.has_remove() && !command.has_at_s()) return {};
  msg::SessionNotes changed = notes_;
  if (command.has_remove()) changed.mutable_notes()->DeleteSubrange(*place_of(changed, command.remove()), 1);
  if (command.has_at_s()) {
    msg::SessionNotes::Note note;
    note.set_number(changed.last_number() + 1);
    note.set_at_s(command.at_s());
    note.set_text(command.text());
    note.set_who(who);
    note.set_written(utc_stamp(now));
    changed.set_last_number(note.number());
    insert(changed, std::move(note));
  }
  if (const Result<void> stored = store(changed); !stored) return stored;
  notes_ = std::move(changed);
  return {};
}

Result<void> SessionNotes::store(const msg::SessionNotes& changed) const {
  const std::string text = program::to_json(changed);
  if (text == "{}")
    return wrong("the name of the note's writer is not UTF-8 text",
                 "sign in with a key whose name is UTF-8 text");  // such a file would have lost all notes
  if (wire::mcap::place_of(session_) != nullptr)
    return wrong("a session in a cluster has no file for notes",
                 "copy the session to a folder (telepalp-record copy), and play the copy");
  const Result<std::string> bytes = wire::mcap::text_beside(session_, text);
  if (!bytes) return bytes.error();
  return program::write_whole_file(wire::notes_file(session_), *bytes, program::Readers::Group);
}

}  // namespace telepalp::playback
