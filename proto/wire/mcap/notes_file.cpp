#include "proto/wire/mcap/notes_file.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "proto/words/error_line.h"

namespace telepalp::wire {
namespace {

constexpr std::uintmax_t kMostFile_B = std::uintmax_t{4} << 20U;  // more than kMostNotes of the longest notes take

Error unreadable(const std::filesystem::path& file, std::string what) {
  return {.what = std::move(what),
          .where = file.string(),
          .fix = "move the file away, or correct the file: its form is that of the reply to GET /playback/notes"};
}

bool has_a_time(const msg::SessionNotes::Note& note) { return std::isfinite(note.at_s()) && note.at_s() >= 0.0; }

/// True: `note` is one that telepalp writes. A file may be made by anybody.
bool is_whole(const msg::LiveNote& note) {
  return note.at_ns() <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) &&
         fault_of_note(note.text()).empty() && fault_of_note(note.who()).empty() &&
         fault_of_note(note.written()).empty();
}

double seconds_from(SessionTime begin, const msg::LiveNote& live) {
  return std::max(0.0, to_seconds(session_time(static_cast<std::int64_t>(live.at_ns())) - begin));
}

msg::SessionNotes::Note note_from(const ToldNote& told, std::uint64_t number) {
  const msg::LiveNote& live = told.note;
  msg::SessionNotes::Note note;
  note.set_number(number);
  note.set_at_s(told.at_s);
  note.set_text(live.text().empty() ? "marked" : live.text());
  note.set_who(live.who());
  note.set_written(live.written());
  return note;
}

}  // namespace

std::string_view fault_of_note(std::string_view text) noexcept {
  if (text.size() > kMostNoteText_B) return "text is longer than 500 bytes";
  const bool one_line =
      std::none_of(text.begin(), text.end(), [](unsigned char letter) { return letter < 0x20 || letter == 0x7f; });
  return one_line ? "" : "text has a line break or another control character";
}

Result<std::vector<ToldNote>> told_notes(const std::filesystem::path& session) {
  Result<McapReader> reader = McapReader::open(session);
  if (!reader) return reader.error();
  const SessionTime begin = session_time(static_cast<std::int64_t>(reader->summary().statistics.message_start_time));
  reader->select({.topics = {std::string(kSessionNotes.name)}});
  std::vector<ToldNote> found;
  while (found.size() < static_cast<std::size_t>(kMostNotes)) {
    const Result<std::optional<Message>> next = reader->next();
    if (!next) continue;  // one damaged chunk; the player counts it
    if (!*next) break;
    msg::LiveNote live;
    if (live.ParseFromString(*(**next).payload) && is_whole(live)) found.push_back({seconds_from(begin, live), live});
  }
  std::ranges::stable_sort(found, {}, &ToldNote::at_s);
  return found;
}

msg::SessionNotes as_session_notes(const std::vector<ToldNote>& told) {
  msg::SessionNotes notes;
  notes.set_last_number(told.size());
  std::uint64_t number = 0;
  for (const ToldNote& one : told) *notes.add_notes() = note_from(one, ++number);
  return notes;
}

Result<msg::SessionNotes> live_notes(const std::filesystem::path& session) {
  const Result<std::vector<ToldNote>> told = told_notes(session);
  if (!told) return told.error();
  return as_session_notes(*told);
}

std::filesystem::path notes_file(const std::filesystem::path& session) {
  std::filesystem::path file = session;
  file += ".notes.json";
  return file;
}

Result<std::optional<std::string>> notes_text(const std::filesystem::path& session) {
  const std::filesystem::path file = notes_file(session);
  std::error_code problem;
  if (!std::filesystem::exists(file, problem)) return std::optional<std::string>();
  if (std::filesystem::file_size(file, problem) > kMostFile_B + mcap::kSealedTextExtra_B || problem)
    return unreadable(file, "this is not a file of notes: it is not a regular file, or larger than 4 MiB");
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in)
    return Error{.what = "the notes cannot be read",
                 .where = file.string(),
                 .fix = "allow the user of this program to read the file, or move the file away"};
  Result<std::string> text = mcap::text_of(std::move(bytes), file.string());
  if (!text) return text.error();
  return std::optional(*std::move(text));
}

Result<msg::SessionNotes> read_notes(const std::filesystem::path& session, msg::SessionNotes live) {
  const std::filesystem::path file = notes_file(session);
  const Result<std::optional<std::string>> json = notes_text(session);
  if (!json) return json.error();
  if (!*json) return live;
  msg::SessionNotes notes;
  if (const auto parsed = google::protobuf::util::JsonStringToMessage(**json, &notes); !parsed.ok())
    return unreadable(file, "the JSON cannot be read: " + first_line(std::string(parsed.message())));
  if (notes.notes_size() > kMostNotes) return unreadable(file, "the file has more than 1000 notes");
  if (!std::all_of(notes.notes().begin(), notes.notes().end(), has_a_time))
    return unreadable(file, "the field at_s of a note is not a number of seconds, 0 or more");
  return notes;
}

}  // namespace telepalp::wire
