#include "support/speech/session_speech.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "proto/wire/topics.h"

namespace telepalp::speech {
namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr std::int64_t kLongest_ms = 366LL * 24 * 3'600'000;  // of a session
constexpr std::size_t kMostText_B = 64 * LoudSpans::kMost;

std::string text_of(const SideSpeech& side) {
  const std::int64_t base_ns = side.spans.empty() ? 0 : to_nanoseconds(side.spans.front().from);
  std::string text = std::to_string(side.messages) + ' ' + std::to_string(base_ns);
  for (const Spoken& span : side.spans)
    text += ' ' + std::to_string((to_nanoseconds(span.from) - base_ns) / kMs_ns) + ' ' +
            std::to_string((to_nanoseconds(span.until) - base_ns) / kMs_ns) + ' ' + std::to_string(span.loudest_dB);
  return text;
}

/// The whole numbers of a text that has nothing else.
class Numbers {
 public:
  explicit Numbers(std::string_view text) noexcept : rest_(text) {}
  /// nullopt: the next word is no number from `least` to `most`, or there is none.
  std::optional<std::int64_t> next(std::int64_t least, std::int64_t most) noexcept {
    std::int64_t number = 0;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (problem != std::errc{} || number < least || number > most) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    if (rest_.starts_with(' ')) rest_.remove_prefix(1);
    return number;
  }
  [[nodiscard]] bool is_at_end() const noexcept { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::optional<Spoken> read_span(Numbers& numbers, std::int64_t base_ns) {
  const auto from_ms = numbers.next(0, kLongest_ms);
  const auto until_ms = numbers.next(from_ms.value_or(kLongest_ms), kLongest_ms);
  const auto loudest_dB = numbers.next(-100, 0);
  if (!from_ms || !until_ms || !loudest_dB) return std::nullopt;
  return Spoken{.from = session_time(base_ns + *from_ms * kMs_ns),
                .until = session_time(base_ns + *until_ms * kMs_ns),
                .loudest_dB = static_cast<int>(*loudest_dB)};
}

std::optional<SideSpeech> read_side(const std::string& text) {
  constexpr std::int64_t kLatest_ns = std::int64_t{1} << 62;
  if (text.size() > kMostText_B) return std::nullopt;
  Numbers numbers(text);
  const auto messages = numbers.next(0, std::int64_t{1} << 40);
  const auto base_ns = numbers.next(0, kLatest_ns);
  if (!messages || !base_ns) return std::nullopt;
  SideSpeech side{.messages = static_cast<std::uint64_t>(*messages)};
  while (!numbers.is_at_end()) {
    const auto span = read_span(numbers, *base_ns);
    if (!span || side.spans.size() == LoudSpans::kMost) return std::nullopt;
    side.spans.push_back(*span);
  }
  return side;
}

/// Adds what `record` tells. False: it is damaged, or too long together with the others.
bool add_record(Speech& speech, const wire::mcap::Metadata& record) {
  for (const auto& [name, text] : record.values) {
    const std::optional<wire::Topic> topic = wire::find_topic(name);
    if (!topic || !topic->spoken) continue;
    const std::optional<SideSpeech> side = read_side(text);
    SideSpeech& all = speech[topic->name];
    if (!side || all.spans.size() + side->spans.size() > LoudSpans::kMost) return false;
    all.messages += side->messages;
    all.spans.insert(all.spans.end(), side->spans.begin(), side->spans.end());
  }
  return true;
}

/// The number of messages of each spoken topic that the file has, by its own count.
std::map<std::string_view, std::uint64_t> spoken_messages(const wire::mcap::Summary& summary) {
  std::map<std::string_view, std::uint64_t> counts;
  for (const auto& [channel, count] : summary.statistics.channel_message_counts) {
    const auto* const stored = summary.channels.find(channel);
    if (stored != nullptr && stored->topic && stored->topic->spoken && count > 0) counts[stored->topic->name] += count;
  }
  return counts;
}

}  // namespace

std::optional<wire::mcap::Metadata> speech_record(const Speech& speech) {
  if (speech.empty()) return std::nullopt;
  wire::mcap::Metadata record{std::string(kSpeechMetadata), {}};
  for (const auto& [topic, side] : speech) record.values.emplace(topic, text_of(side));
  return record;
}

std::optional<Speech> recorded_speech(wire::McapReader& reader) {
  const std::map<std::string_view, std::uint64_t> counts = spoken_messages(reader.summary());
  Speech speech;
  for (const wire::mcap::MetadataIndex& index : reader.summary().metadata) {
    if (index.name != kSpeechMetadata || counts.empty()) continue;
    const Result<wire::mcap::Metadata> record = reader.read(index);
    if (!record || !add_record(speech, *record)) return std::nullopt;
  }
  std::erase_if(speech, [&](const auto& side) { return !counts.contains(side.first); });
  const bool is_whole = std::ranges::all_of(counts, [&](const auto& one) {
    const auto side = speech.find(one.first);
    return side != speech.end() && side->second.messages == one.second;
  });
  if (!is_whole) return std::nullopt;
  for (auto& [topic, side] : speech) std::ranges::sort(side.spans, {}, &Spoken::from);
  return speech;
}

Speech surveyed_speech(wire::McapReader& reader, const std::function<bool()>& goes_on) {
  std::vector<std::string> spoken;
  for (const wire::Topic& topic : wire::kTopics)
    if (topic.spoken) spoken.emplace_back(topic.name);
  reader.select({.topics = std::move(spoken)});
  SpeechSurvey survey;
  while (goes_on()) {
    const Result<std::optional<wire::Message>> message = reader.next();
    if (!message) continue;  // one damaged chunk
    if (!*message) break;
    survey.add(**message);
  }
  return survey.speech();
}

}  // namespace telepalp::speech
