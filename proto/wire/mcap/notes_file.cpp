#include "proto/wire/mcap/notes_file.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

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

}  // namespace

std::filesystem::path notes_file(const std::filesystem::path& session) {
  std::filesystem::path file = session;
  file += ".notes.json";
  return file;
}

Result<msg::SessionNotes> read_notes(const std::filesystem::path& session) {
  const std::filesystem::path file = notes_file(session);
  std::error_code problem;
  msg::SessionNotes notes;
  if (!std::filesystem::exists(file, problem)) return notes;
  if (std::filesystem::file_size(file, problem) > kMostFile_B || problem)
    return unreadable(file, "this is not a file of notes: it is not a regular file, or larger than 4 MiB");
  std::ifstream in(file, std::ios::binary);
  const std::string json{std::istreambuf_iterator<char>(in), {}};
  if (!in)
    return Error{.what = "the notes cannot be read",
                 .where = file.string(),
                 .fix = "allow the user of this program to read the file, or move the file away"};
  if (const auto parsed = google::protobuf::util::JsonStringToMessage(json, &notes); !parsed.ok()) {
    return unreadable(file, "the JSON cannot be read: " + first_line(std::string(parsed.message())));
  }
  if (notes.notes_size() > kMostNotes) return unreadable(file, "the file has more than 1000 notes");
  if (!std::all_of(notes.notes().begin(), notes.notes().end(), has_a_time))
    return unreadable(file, "the field at_s of a note is not a number of seconds, 0 or more");
  return notes;
}

}  // namespace telepalp::wire
