#include "server/playback/timeline.h"

#include <algorithm>
#include <set>

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

/// How far back a seek reads for a key frame, a colour image and a camera model: they come at least every second,
/// unless much was lost.
constexpr Nanoseconds kLookBack[] = {1s, 10s};

/// The station's states of this time show the hand of the last picture, whose capture is at most this old.
constexpr Nanoseconds kStatesBack = 150ms;

/// A group of pictures that needs more memory is not from telepalp's encoder: it is skipped up to its next key
/// frame.
constexpr std::size_t kMostGroupBytes = std::size_t{64} << 20;

std::size_t bytes_of(const std::vector<wire::Message>& messages) {
  std::size_t bytes = 0;
  for (const wire::Message& message : messages) bytes += message.payload->size();
  return bytes;
}

bool is_wanted(const std::vector<std::string>& topics, std::string_view name) {
  return std::any_of(topics.begin(), topics.end(), [&](const std::string& wanted) {
    return wanted.ends_with('*') ? name.starts_with(std::string_view(wanted).substr(0, wanted.size() - 1))
                                 : name == wanted;
  });
}

}  // namespace

Timeline::Timeline(wire::McapReader reader, std::vector<std::string> topics)
    : reader_(std::move(reader)), topics_(std::move(topics)) {
  const wire::mcap::Statistics& statistics = reader_.summary().statistics;
  begin_ = session_time(static_cast<std::int64_t>(statistics.message_start_time));
  end_ = session_time(static_cast<std::int64_t>(statistics.message_end_time));
  reader_.select({.topics = topics_});
}

Result<Timeline> Timeline::open(const std::filesystem::path& file, std::vector<std::string> topics,
                                const wire::mcap::Progress& progress) {
  Result<wire::McapReader> reader = wire::McapReader::open(file, progress);
  if (!reader) return reader.error();
  const wire::mcap::Summary& summary = reader->summary();
  const bool has_one =
      std::any_of(summary.channels.all().begin(), summary.channels.all().end(),
                  [&](const auto& entry) { return entry.second.topic && is_wanted(topics, entry.second.topic->name); });
  if (summary.statistics.message_count == 0)
    return Error{.what = "holds no message, or its summary does not count its messages",
                 .where = file.string(),
                 .fix = "give a session with messages, or try telepalp-record repair " + file.string()};
  if (!has_one)
    return Error{.what = "holds no message on the topics that are played",
                 .where = file.string(),
                 .fix = "add ,topics=A+B to --source, with topics that this command lists: telepalp-record info " +
                        file.string()};
  if (summary.statistics.message_end_time > static_cast<std::uint64_t>(INT64_MAX) ||
      summary.statistics.message_start_time > summary.statistics.message_end_time)
    return Error{.what = "its index states an end before its beginning, or a time out of range",
                 .where = file.string(),
                 .fix = "telepalp-record repair " + file.string()};
  return Timeline(std::move(*reader), std::move(topics));
}

bool Timeline::has_speech() const {
  return std::ranges::any_of(reader_.summary().channels.all(), [&](const auto& entry) {
    const auto& topic = entry.second.topic;
    return topic && topic->spoken && is_played(topic->name);
  });
}

bool Timeline::is_played(std::string_view topic) const { return is_wanted(topics_, topic); }

/// The topics of the file whose last message a receiver needs.
std::vector<std::string> Timeline::needed_topics() const {
  std::set<std::string_view> needed;  // a topic may have several channels
  for (const auto& [id, stored] : reader_.summary().channels.all()) {
    if (!stored.topic || !is_played(stored.topic->name)) continue;
    for (const std::string_view name : {wire::kCameraInfo.name, wire::kCameraColorInfo.name, wire::kCameraDepth.name,
                                        wire::kCameraColor.name, wire::kCameraColorVideo.name})
      if (stored.topic->name == name) needed.insert(name);
  }
  return {needed.begin(), needed.end()};
}

/// The earliest time at which reading must begin for the messages that are valid at `at`: `back` before, or at the last
/// key frame of a topic if that is earlier.
SessionTime Timeline::begin_of_seek(SessionTime at, Nanoseconds back) {
  SessionTime from = at - back;
  for (const wire::Topic& topic : wire::kTopics)
    if (topic.predicted && is_played(topic.name))
      from = std::min(from, reader_.last_key_frame(topic, at).value_or(from));
  return from;
}

std::vector<wire::Message> Timeline::seek(SessionTime at) {
  const std::vector<std::string> needed = needed_topics();
  std::vector<std::string> topics = needed;
  if (is_played(wire::kStationState.name)) topics.emplace_back(wire::kStationState.name);
  std::map<std::string_view, std::vector<wire::Message>> found;
  std::vector<wire::Message> all;
  for (const Nanoseconds back : kLookBack) {
    if (topics.empty()) break;
    found.clear();
    all.clear();
    reader_.select({.topics = topics, .from = begin_of_seek(at, back), .until = at});
    while (std::optional<wire::Message> message = next()) {
      if (message->topic.name == wire::kStationState.name) {
        if (message->published >= at - kStatesBack) all.push_back(std::move(*message));
        continue;
      }
      std::vector<wire::Message>& of_topic = found[message->topic.name];
      if (message->key_frame) of_topic.clear();
      if (message->key_frame || !of_topic.empty()) of_topic.push_back(std::move(*message));
      if (bytes_of(of_topic) > kMostGroupBytes) of_topic.clear();
      if (of_topic.empty()) found.erase(message->topic.name);
    }
    if (found.size() == needed.size()) break;
  }
  for (auto& [topic, messages] : found)
    all.insert(all.end(), std::make_move_iterator(messages.begin()), std::make_move_iterator(messages.end()));
  std::stable_sort(all.begin(), all.end(),
                   [](const wire::Message& a, const wire::Message& b) { return a.published < b.published; });
  reader_.select({.topics = topics_, .from = at, .until = {}});
  return all;
}

std::optional<wire::Message> Timeline::next() {
  for (;;) {
    Result<std::optional<wire::Message>> message = reader_.next();
    if (message) return std::move(*message);
    ++damaged_;  // the reader continues after the damaged chunk
  }
}

}  // namespace telepalp::playback
