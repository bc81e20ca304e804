#include "clients/record/inspect.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/reader.h"
#include "support/program/json.h"
#include "support/program/log.h"

namespace telepalp::record {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double duration_s(const wire::mcap::Statistics& statistics) {
  if (statistics.message_end_time < statistics.message_start_time) return 0.0;
  return static_cast<double>(statistics.message_end_time - statistics.message_start_time) * 1e-9;
}

std::string first_line(const SessionFacts& facts) {
  const double size_MB = static_cast<double>(facts.bytes) / 1e6;
  std::string line = formatted("%.1f s, %llu messages in %llu chunks, %.1f MB", facts.seconds,
                               static_cast<unsigned long long>(facts.messages),
                               static_cast<unsigned long long>(facts.chunks), size_MB);
  if (facts.seconds >= 1.0) line += formatted(" (%.1f MB/min)", size_MB * 60.0 / facts.seconds);
  return line + "\n";
}

std::string made_by(const SessionFacts& facts) {
  if (facts.program.empty()) return {};
  std::string line = "made by " + facts.program + " " + facts.version;
  if (!facts.commit.empty()) line += " (" + facts.commit + ")";
  if (!facts.source.empty()) line += " from " + facts.source;
  return program::escaped(line) + "\n";
}

/// The bound on the error of the depth in the file: the recorder's note at the end of the file or, without it (an
/// encoded or repaired file), the bound in the first image.
std::string depth_of(wire::McapReader& reader) {
  for (const wire::mcap::MetadataIndex& index : reader.summary().metadata) {
    if (index.name != wire::kRecordingMetadata) continue;
    const Result<wire::mcap::Metadata> metadata = reader.read(index);
    if (metadata && metadata->values.contains("depth")) return metadata->values.at("depth");
  }
  reader.select({.topics = {std::string(wire::kCameraDepth.name)}});
  const auto first = reader.next();
  msg::DepthImage image;
  if (!first || !*first || !image.ParseFromString(*(*first)->payload)) return {};
  return wire::in_words(wire::depth_fidelity(image));
}

std::vector<SessionFacts::Topic> topics_of(const wire::mcap::Summary& summary) {
  const double seconds = duration_s(summary.statistics);
  std::vector<SessionFacts::Topic> topics;
  for (const auto& [id, stored] : summary.channels.all()) {
    const auto count = summary.statistics.channel_message_counts.find(id);
    const std::uint64_t messages = count == summary.statistics.channel_message_counts.end() ? 0 : count->second;
    topics.push_back({.name = stored.channel.topic,
                      .type = stored.schema == nullptr ? "" : stored.schema->name,
                      .messages = messages,
                      .rate_Hz = seconds > 0.0 && messages > 1 ? static_cast<double>(messages - 1) / seconds : 0.0});
  }
  std::ranges::sort(topics, {}, &SessionFacts::Topic::name);
  return topics;
}

std::string table(const std::vector<SessionFacts::Topic>& topics) {
  std::size_t topic_width = 5;
  std::size_t type_width = 4;
  for (const SessionFacts::Topic& topic : topics) {
    topic_width = std::max(topic_width, program::escaped(topic.name).size());
    type_width = std::max(type_width, program::escaped(topic.type).size());
  }
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text + "  ";
  };
  std::string text = padded("topic", topic_width) + padded("type", type_width) + "messages  rate_Hz\n";
  for (const SessionFacts::Topic& topic : topics) {
    text += padded(program::escaped(topic.name), topic_width) + padded(program::escaped(topic.type), type_width) +
            formatted("%8llu", static_cast<unsigned long long>(topic.messages));
    if (topic.rate_Hz > 0.0) text += formatted("  %7.1f", topic.rate_Hz);
    text += "\n";
  }
  return text;
}

}  // namespace

Result<SessionFacts> inspect(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  std::error_code ignored;
  const wire::mcap::Summary& summary = reader->summary();
  return SessionFacts{.seconds = duration_s(summary.statistics),
                      .messages = summary.statistics.message_count,
                      .chunks = summary.chunks.size(),
                      .bytes = std::filesystem::file_size(file, ignored),
                      .program = session->program,
                      .version = session->version,
                      .commit = session->commit,
                      .source = session->source,
                      .depth = depth_of(*reader),
                      .topics = topics_of(summary)};
}

std::string in_words(const SessionFacts& facts) {
  const std::string depth = facts.depth.empty() ? "" : program::escaped("depth: " + facts.depth) + "\n";
  return first_line(facts) + made_by(facts) + depth + "\n" + table(facts.topics);
}

std::string in_json(const SessionFacts& facts) {
  program::Json json;
  json.begin_object();
  json.add("seconds", facts.seconds);
  json.add("messages", facts.messages);
  json.add("chunks", facts.chunks);
  json.add("bytes", facts.bytes);
  for (const auto& [key, text] :
       {std::pair{"program", &facts.program}, std::pair{"version", &facts.version}, std::pair{"commit", &facts.commit},
        std::pair{"source", &facts.source}, std::pair{"depth", &facts.depth}})
    text->empty() ? json.add_null(key) : json.add(key, *text);
  json.begin_list("topics");
  for (const SessionFacts::Topic& topic : facts.topics) {
    json.begin_object();
    json.add("name", topic.name);
    json.add("type", topic.type);
    json.add("messages", topic.messages);
    json.add("rate_Hz", topic.rate_Hz);
    json.end_object();
  }
  json.end_list();
  json.end_object();
  return std::move(json).finish();
}

}  // namespace telepalp::record
