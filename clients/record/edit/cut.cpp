#include "clients/record/edit/cut.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "clients/record/edit/session_copy.h"

namespace telepalp::record {
namespace {

constexpr std::uint64_t kPreludeNs = 10'000'000'000;  // what is published again comes more often than this

/// A group of pictures that needs more memory is not from telepalp's encoder: it is skipped up to its next key frame.
constexpr std::size_t kMostGroupBytes = std::size_t{64} << 20;

std::vector<std::string> chosen_topics(const wire::mcap::Summary& summary, const TopicFilter& filter) {
  std::vector<std::string> topics;
  for (const auto& [id, stored] : summary.channels.all())
    if (filter.matches(stored.channel.topic)) topics.push_back(stored.channel.topic);
  return topics;
}

wire::McapSelection between(std::vector<std::string> topics, std::uint64_t from, std::uint64_t until) {
  return {.topics = std::move(topics),
          .from = session_time(static_cast<std::int64_t>(from)),
          .until = session_time(static_cast<std::int64_t>(std::min<std::uint64_t>(until, INT64_MAX)))};
}

/// Gives each selected message to `take`; damaged places are noted and skipped.
template <class Take>
Result<void> for_each(wire::McapReader& reader, std::vector<std::string>& damages, Take take) {
  for (;;) {
    const auto next = reader.next_stored();
    if (!next && damages.size() < kMostDamagesTold) damages.push_back(next.error().what);
    if (!next) continue;
    if (!*next) return {};
    if (const Result<void> taken = take(**next); !taken) return taken;
  }
}

using KeptByTopic = std::map<std::string, std::vector<KeptMessage>>;

/// Keeps the messages of each topic from its newest key frame between `since` and `from` on.
void keep_newest(wire::McapReader& reader, std::vector<std::string> topics, std::uint64_t since, std::uint64_t from,
                 KeptByTopic& kept, std::vector<std::string>& damages) {
  if (topics.empty()) return;
  reader.select(between(std::move(topics), since, from));
  (void)for_each(reader, damages, [&](const wire::mcap::StoredMessage& message) -> Result<void> {
    std::vector<KeptMessage>& of_topic = kept[message.channel->channel.topic];
    if (is_key_frame(message)) of_topic.clear();
    of_topic.emplace_back(message);
    std::size_t bytes = 0;
    for (const KeptMessage& kept_message : of_topic) bytes += kept_message.bytes();
    if (bytes > kMostGroupBytes) of_topic.clear();
    return {};
  });
}

/// Time of the last key frame before `from`; nullopt: there is none, or the file has no index of key frames.
std::optional<std::uint64_t> last_key_frame(wire::McapReader& reader, const wire::Topic& topic, std::uint64_t from) {
  const auto last = reader.last_key_frame(topic, session_time(static_cast<std::int64_t>(from)));
  return last ? std::optional(static_cast<std::uint64_t>(to_nanoseconds(*last))) : std::nullopt;
}

/// The messages before `from` that a player needs at `from`, in order of time.
std::vector<KeptMessage> prelude(wire::McapReader& reader, std::uint64_t from, const TopicFilter& filter,
                                 std::vector<std::string>& damages) {
  std::vector<std::string> recent;
  std::vector<std::string> of_any_age;
  std::uint64_t since = from > kPreludeNs ? from - kPreludeNs : 0;
  for (const wire::Topic& topic : wire::kTopics) {
    if (!(topic.latched() || topic.predicted) || !filter.matches(topic.name)) continue;
    (topic.validity == wire::Validity::UntilChanged ? of_any_age : recent).emplace_back(topic.name);
    if (topic.predicted) since = std::min(since, last_key_frame(reader, topic, from).value_or(since));
  }
  KeptByTopic kept, old;
  keep_newest(reader, std::move(recent), since, from, kept, damages);
  keep_newest(reader, std::move(of_any_age), 0, from, old, damages);
  for (auto& [topic, messages] : old)
    for (KeptMessage& message : messages)  // with an earlier time of its own, the cut would seem to begin then
      if (message.log_time() + kPreludeNs < from) message.place_at(from);
  kept.merge(old);
  std::vector<KeptMessage> all;
  for (auto& [topic, messages] : kept) std::ranges::move(messages, std::back_inserter(all));
  std::stable_sort(all.begin(), all.end(),
                   [](const KeptMessage& a, const KeptMessage& b) { return a.log_time() < b.log_time(); });
  return all;
}

wire::mcap::Metadata note_of(const std::filesystem::path& file, const CutOptions& options) {
  wire::mcap::Metadata note{"telepalp.cut",
                            {{"file", file.filename().string()}, {"from_s", std::to_string(to_seconds(options.from))}}};
  if (options.to) note.values["to_s"] = std::to_string(to_seconds(*options.to));
  return note;
}

Error no_such_topic(const std::filesystem::path& file) {
  return {.what = "no topic of the session matches --topics",
          .where = file.string(),
          .fix = "give topics that are listed by telepalp-record info " + file.string()};
}

Error nothing_there(const std::filesystem::path& file, const wire::mcap::Statistics& statistics) {
  const double seconds = static_cast<double>(statistics.message_end_time - statistics.message_start_time) * 1e-9;
  return {.what = "no message lies between --from and --to on the chosen topics; the session lasts " +
                  std::to_string(seconds) + " s",
          .where = file.string(),
          .fix = "give times within the session, and topics that are listed by telepalp-record info " + file.string()};
}

}  // namespace

Result<EditReport> cut(const std::filesystem::path& file, const std::filesystem::path& out, const CutOptions& options) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  const wire::mcap::Statistics& statistics = reader->summary().statistics;
  const std::uint64_t from = statistics.message_start_time + static_cast<std::uint64_t>(options.from.count());
  const std::uint64_t until =
      options.to ? statistics.message_start_time + static_cast<std::uint64_t>(options.to->count()) : INT64_MAX;
  const std::vector<std::string> topics = chosen_topics(reader->summary(), options.topics);
  if (topics.empty()) return no_such_topic(file);
  if (from > statistics.message_end_time || until <= from) return nothing_there(file, statistics);

  EditReport report;
  const std::vector<KeptMessage> before = prelude(*reader, from, options.topics, report.damages);
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, *session);
  if (!writer) return writer.error();
  Result<void> copied = NotesCopy(*writer).add(*reader);
  if (copied) copied = writer->add(note_of(file, options));
  for (const KeptMessage& message : before)
    if (copied) copied = message.copy_to(*writer);
  report.messages = before.size();
  reader->select(between(topics, from, until));
  if (copied)
    copied = for_each(*reader, report.damages, [&](const wire::mcap::StoredMessage& message) {
      ++report.messages;
      return writer->copy(message);
    });
  if (copied && report.messages == 0) copied = nothing_there(file, statistics);
  copied = writer->finish(copied);
  for (std::string& damage : report.damages) damage = file.string() + ": " + damage;
  if (!copied) return copied.error();
  return report;
}

}  // namespace telepalp::record
