#include "server/origin/live_notes.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/topics.h"
#include "proto/words/numbers/utc_text.h"
#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

constexpr double kLongestAgo_s = 60.0;
constexpr const char* kExample = "send JSON such as {\"ago_s\": 0.2, \"text\": \"tender here\"}";

Error wrong(std::string what) { return {.what = std::move(what), .where = "marks", .fix = kExample}; }

}  // namespace

Result<void> LiveNotes::mark(const std::string& json, const std::string& who) {
  msg::MarkCommand command;
  if (const Result<void> read = program::read_json(json, command, "marks", kExample); !read) return read;
  if (!(command.ago_s() >= 0.0 && command.ago_s() <= kLongestAgo_s)) return wrong("ago_s is not from 0 to 60");
  if (const std::string_view fault = wire::fault_of_note(command.text()); !fault.empty())
    return wrong(std::string(fault));
  if (state_.count() >= static_cast<std::uint32_t>(wire::kMostNotes))
    return wrong("1000 moments are marked, the most that a session may have");
  if (!publish_) return {};
  const SessionTime now = clock_.now();
  msg::LiveNote& note = *state_.mutable_newest();
  note.set_at_ns(
      static_cast<std::uint64_t>(std::max<std::int64_t>(0, to_nanoseconds(now - from_seconds(command.ago_s())))));
  note.set_text(command.text());
  note.set_who(who);
  note.set_written(utc_stamp(std::chrono::system_clock::now()));
  state_.set_count(state_.count() + 1);
  publish_(wire::make_message(wire::kSessionNotes, now, note));
  return {};
}

Resource LiveNotes::resource() {
  return {.state = [this] { return state_message(state_); },
          .change = at_once([this](const std::string& json, const std::string& who) { return mark(json, who); })};
}

}  // namespace telepalp::origin
