#include "clients/record/inspect.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/reader.h"
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

std::string first_line(const wire::mcap::Statistics& statistics, std::size_t chunks, double size_MB) {
  const double seconds = duration_s(statistics);
  std::string line = formatted("%.1f s, %llu messages in %zu chunks, %.1f MB", seconds,
                               static_cast<unsigned long long>(statistics.message_count), chunks, size_MB);
  if (seconds >= 1.0) line += formatted(" (%.1f MB/min)", size_MB * 60.0 / seconds);
  return line + "\n";
}

std::string made_by(const wire::SessionInfo& session) {
  if (session.program.empty()) return {};
  std::string line = "made by " + session.program + " " + session.version;
  if (!session.commit.empty()) line += " (" + session.commit + ")";
  if (!session.source.empty()) line += " from " + session.source;
  return program::escaped(line) + "\n";
}

/// How far the depth in the file is from what the camera measured: as the recorder noted it at the end, and else (an
/// encoded or repaired file) as the first image tells.
std::string depth_of(wire::McapReader& reader) {
  const auto line = [](const std::string& words) { return program::escaped("depth: " + words) + "\n"; };
  for (const wire::mcap::MetadataIndex& index : reader.summary().metadata) {
    if (index.name != wire::kRecordingMetadata) continue;
    const Result<wire::mcap::Metadata> metadata = reader.read(index);
    if (metadata && metadata->values.contains("depth")) return line(metadata->values.at("depth"));
  }
  reader.select({.topics = {std::string(wire::kCameraDepth.name)}});
  const auto first = reader.next();
  msg::DepthImage image;
  if (!first || !*first || !image.ParseFromString(*(*first)->payload)) return {};
  return line(wire::in_words(wire::depth_fidelity(image)));
}

struct Row {
  std::string topic;
  std::string type;
  std::uint64_t messages;
};

std::vector<Row> rows_of(const wire::mcap::Summary& summary) {
  std::vector<Row> rows;
  for (const auto& [id, stored] : summary.channels.all()) {
    const auto count = summary.statistics.channel_message_counts.find(id);
    rows.push_back({program::escaped(stored.channel.topic),
                    stored.schema == nullptr ? "" : program::escaped(stored.schema->name),
                    count == summary.statistics.channel_message_counts.end() ? 0 : count->second});
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.topic < b.topic; });
  return rows;
}

std::string table(const std::vector<Row>& rows, double seconds) {
  std::size_t topic_width = 5;
  std::size_t type_width = 4;
  for (const Row& row : rows) {
    topic_width = std::max(topic_width, row.topic.size());
    type_width = std::max(type_width, row.type.size());
  }
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text + "  ";
  };
  std::string text = padded("topic", topic_width) + padded("type", type_width) + "messages  rate_Hz\n";
  for (const Row& row : rows) {
    text += padded(row.topic, topic_width) + padded(row.type, type_width) +
            formatted("%8llu", static_cast<unsigned long long>(row.messages));
    if (seconds > 0.0 && row.messages > 1)
      text += formatted("  %7.1f", static_cast<double>(row.messages - 1) / seconds);
    text += "\n";
  }
  return text;
}

}  // namespace

Result<std::string> inspect(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  std::error_code ignored;
  const double size_MB = static_cast<double>(std::filesystem::file_size(file, ignored)) / 1e6;
  const wire::mcap::Summary& summary = reader->summary();
  return first_line(summary.statistics, summary.chunks.size(), size_MB) + made_by(*session) + depth_of(*reader) + "\n" +
         table(rows_of(summary), duration_s(summary.statistics));
}

}  // namespace telepalp::record
