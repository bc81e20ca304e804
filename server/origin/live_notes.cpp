#include "server/origin/live_notes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/topics.h"
#include "proto/words/numbers/utc_text.h"
#include "support/program/message_json.h"

namespace telepalp::origin {
namespace {

constexpr double kLongestAgo_s = 60.0;
constexpr double kFarthest_m = 10.0;
constexpr int kMostNewest = 4;
constexpr const char* kMarkExample = "send JSON such as {\"ago_s\": 0.2, \"text\": \"tender here\"}";

/// NaN is not near.
bool is_near(const msg::Vec3& at_m) { return std::hypot(at_m.x(), at_m.y(), at_m.z()) <= kFarthest_m; }

Error wrong_mark(std::string what) { return {.what = std::move(what), .where = "marks", .fix = kMarkExample}; }

}  // namespace

Result<void> LiveNotes::mark(const std::string& json, const std::string& who) {
  msg::MarkCommand command;
  if (const Result<void> read = program::read_json(json, command, "marks", kMarkExample); !read) return read;
  if (!(command.ago_s() >= 0.0 && command.ago_s() <= kLongestAgo_s)) return wrong_mark("ago_s is not from 0 to 60");
  if (const std::string_view fault = wire::fault_of_note(command.text()); !fault.empty())
    return wrong_mark(std::string(fault));
  if (command.has_at_m() && !is_near(command.at_m())) return wrong_mark("at_m is not within 10 m of the camera");
  if (state_.count() >= static_cast<std::uint32_t>(wire::kMostNotes))
    return wrong_mark("1000 moments are marked, the most that a session may have");
  if (!publish_) return {};
  const SessionTime now = clock_.now();
  msg::LiveNote note;
  note.set_at_ns(
      static_cast<std::uint64_t>(std::max<std::int64_t>(0, to_nanoseconds(now - from_seconds(command.ago_s())))));
  note.set_text(command.text());
  note.set_who(who);
  note.set_written(utc_stamp(std::chrono::system_clock::now()));
  if (command.has_at_m()) *note.mutable_at_m() = command.at_m();
  if (state_.newest_size() == kMostNewest) state_.mutable_newest()->DeleteSubrange(0, 1);
  *state_.add_newest() = note;
  state_.set_count(state_.count() + 1);
  publish_(wire::make_message(wire::kSessionNotes, now, note));
  return {};
}

Resource LiveNotes::resource() {
  return {.state = [this] { return state_message(state_); },
          .change = at_once([this](const std::string& json, const std::string& who) { return mark(json, who); })};
}

}  // namespace telepalp::origin
