#include "server/playback/comparison/session_comparison.h"

#include <algorithm>
#include <utility>

#include "proto/words/counted.h"
#include "server/playback/comparison/compare_tracks.h"
#include "server/playback/comparison/state_track.h"
#include "support/program/message_json.h"

namespace telepalp::playback {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhere = "playback/comparison";
constexpr const char* kComparisonExample =
    "send JSON such as {\"with\": \"session.mcap\"}, with a session that GET /playback/comparison lists";

msg::ComparisonState failed(const Error& error) {
  msg::ComparisonState state;
  state.set_problem(to_string(error));
  return state;
}

/// Says what the comparison leaves out of `file`.
void say_left_out(const SessionComparison::Say& say, const fs::path& file, const StateTrack& track) {
  const std::string begin = "the page's comparison leaves out a part of " + file.filename().string() + ": ";
  if (track.damaged > 0)
    say(begin + counted(track.damaged, "damaged part", "damaged parts") +
        ". fix: telepalp-record verify names the damage");
  if (track.is_cut)
    say(begin + "what follows the first " + std::to_string(kMostTrackPoints) +
        " states, which are two hours. fix: compare the whole sessions by telepalp-report A B");
}

}  // namespace

Result<std::unique_ptr<SessionComparison>> SessionComparison::open(fs::path played, fs::path folder, Say say) {
  std::error_code problem;
  if (!fs::is_directory(folder, problem))
    return Error{
        .what = "is not a folder", .where = folder.string(), .fix = "name a folder of sessions by --compare-dir"};
  return std::unique_ptr<SessionComparison>(
      new SessionComparison(std::move(played), std::move(folder), std::move(say)));
}

std::vector<std::string> SessionComparison::sessions() const {
  std::vector<std::string> names;
  std::error_code problem;
  for (auto entry = fs::directory_iterator(folder_, problem); !problem && entry != fs::directory_iterator();
       entry.increment(problem)) {
    std::error_code unknown;
    if (entry->path().extension() == ".mcap" && entry->is_regular_file(unknown))
      names.push_back(entry->path().filename().string());
    if (names.size() == kMostSessions) break;
  }
  std::ranges::sort(names);
  return names;
}

Result<void> SessionComparison::apply(const std::string& json) {
  msg::ComparisonCommand command;
  if (const Result<void> read = program::read_json(json, command, kWhere, kComparisonExample); !read)
    return read.error();
  if (!command.has_with()) return {};
  const std::vector<std::string> known = sessions();
  if (!command.with().empty() && std::ranges::find(known, command.with()) == known.end())
    return Error{.what = "the folder of --compare-dir holds no session with the name that the request gives",
                 .where = kWhere,
                 .fix = kComparisonExample};
  begin(command.with());
  return {};
}

void SessionComparison::begin(const std::string& with) {
  stop();
  state_.Clear();
  if (with.empty()) return;
  state_.set_with(with);
  stopping_ = false;
  thread_ = std::thread([this, other = folder_ / with] { compare(other); });
}

void SessionComparison::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void SessionComparison::compare(const fs::path& other) {
  const Result<StateTrack> a = read_track(played_, stopping_);
  const Result<StateTrack> b = a ? read_track(other, stopping_) : a;
  if (a) say_left_out(say_, played_, *a);
  if (a && b) say_left_out(say_, other, *b);
  msg::ComparisonState state = b ? compare_tracks(*a, *b) : failed(b.error());
  const std::scoped_lock lock(mutex_);
  state.set_with(state_.with());
  state.set_complete(true);
  state_ = std::move(state);
}

msg::ComparisonState SessionComparison::state() const {
  msg::ComparisonState state;
  {
    const std::scoped_lock lock(mutex_);
    state = state_;
  }
  for (const std::string& name : sessions()) state.add_sessions(name);
  return state;
}

}  // namespace telepalp::playback
