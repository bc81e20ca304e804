#include <algorithm>
#include <cstdio>
#include <utility>

#include "clients/record/facts/session_facts.h"
#include "proto/words/counted.h"
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

std::string first_line(const SessionFacts& facts) {
  const double size_MB = static_cast<double>(facts.bytes) / 1e6;
  std::string line = formatted(
      "%.1f s from the first message, which may have been sent before the recording began, to the last; %s in %s, "
      "%.1f MB",
      facts.seconds, counted(facts.messages, "message", "messages").c_str(),
      counted(facts.chunks, "chunk", "chunks").c_str(), size_MB);
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

std::string clock_line(const SessionFacts& facts) {
  std::string line;
  if (facts.clock)
    line = formatted(
        "the server's wall clock drifts %.1f ppm from the server's session clock; largest jump of the wall clock "
        "between two messages of /clock: %.3f ms",
        facts.clock->drift_ppm, facts.clock->largest_step_ms);
  if (const auto found = facts.recording.find("clock_uncertainty_us"); found != facts.recording.end())
    line += (line.empty() ? "" : "; ") + ("error of the recorder's session clock: at most " + found->second + " us");
  return line.empty() ? "" : program::escaped(line) + "\n";
}

std::string gaps_line(const SessionFacts& facts) {
  const auto gaps = facts.recording.find("gaps");
  if (gaps == facts.recording.end() || gaps->second == "0") return {};
  const auto seconds = facts.recording.find("gap_s");
  return program::escaped(
             "connection to the server lost " + (gaps->second == "1" ? "once" : gaps->second + " times") +
             (seconds == facts.recording.end() ? "" : "; no connection for " + seconds->second + " s in all")) +
         "\n";
}

std::string named(const char* what, const std::string& text) {
  return text.empty() ? "" : what + program::escaped(text) + "\n";
}

/// Columns of text, each as wide as its widest cell. The first `left` columns are aligned to the left.
std::string table(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], row[column].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string space(widths[column] - row[column].size(), ' ');
      line += (column == 0 ? "" : "  ") + (column < left ? row[column] + space : space + row[column]);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string topic_table(const SessionFacts& facts) {
  std::vector<std::vector<std::string>> rows{{"topic", "type", "messages", "rate_Hz", "MB", "longest_gap_s", "lost"}};
  for (const SessionFacts::Topic& topic : facts.topics)
    rows.push_back({program::escaped(topic.name), program::escaped(topic.type), std::to_string(topic.messages),
                    topic.rate_Hz > 0.0 ? formatted("%.1f", topic.rate_Hz) : "",
                    formatted("%.3f", static_cast<double>(topic.bytes) / 1e6),
                    topic.messages > 1 ? formatted("%.3f", topic.longest_gap_s) : "", std::to_string(topic.lost)});
  return table(rows, 2);
}

std::string peer_table(const SessionFacts& facts) {
  if (facts.peers.empty()) return {};
  std::vector<std::vector<std::string>> rows{
      {"peer", "address", "sender", "published", "dropped_for_peer", "dropped_by_peer"}};
  for (const SessionFacts::Peer& peer : facts.peers)
    rows.push_back({peer.name.empty() ? "unknown" : program::escaped(peer.name), program::escaped(peer.address),
                    peer.sender == 0 ? "" : std::to_string(peer.sender), std::to_string(peer.messages),
                    std::to_string(peer.dropped_before_it), std::to_string(peer.dropped_by_it)});
  return "\npeer: a program that sent or received messages\n"
         "sender: the peer's number in its messages; empty: the peer published nothing\n"
         "published: messages of the peer in the file\n"
         "dropped_for_peer: messages that the server dropped because the peer read too slowly\n"
         "dropped_by_peer: depth frames and ticks that the peer itself reported as dropped\n" +
         table(rows, 2);
}

void add_text(program::Json& json, const char* key, const std::string& text) {
  text.empty() ? json.add_null(key) : json.add(key, text);
}

void add_topics(program::Json& json, const SessionFacts& facts) {
  json.begin_list("topics");
  for (const SessionFacts::Topic& topic : facts.topics) {
    json.begin_object();
    json.add("name", topic.name);
    json.add("type", topic.type);
    json.add("messages", topic.messages);
    json.add("bytes", topic.bytes);
    json.add("rate_Hz", topic.rate_Hz);
    json.add("longest_gap_s", topic.longest_gap_s);
    json.add("lost", topic.lost);
    json.add("back_in_time", topic.back_in_time);
    json.add("unreadable", topic.unreadable);
    json.end_object();
  }
  json.end_list();
}

void add_peers(program::Json& json, const SessionFacts& facts) {
  json.begin_list("peers");
  for (const SessionFacts::Peer& peer : facts.peers) {
    json.begin_object();
    add_text(json, "name", peer.name);
    add_text(json, "address", peer.address);
    json.add("sender", std::uint64_t{peer.sender});
    json.add("published", peer.messages);
    json.add("dropped_for_it", peer.dropped_before_it);
    json.add("dropped_by_it", peer.dropped_by_it);
    json.end_object();
  }
  json.end_list();
}

void add_texts(program::Json& json, const char* key, const std::vector<std::string>& texts) {
  json.begin_list(key);
  for (const std::string& text : texts) json.add({}, text);
  json.end_list();
}

}  // namespace

std::string in_words(const SessionFacts& facts) {
  std::string text = first_line(facts) + made_by(facts) + named("recorded by: ", facts.recorded_by) +
                     named("consent: ", facts.consent) +
                     named("consent to recording what is said: ", facts.voice_consent) + named("depth: ", facts.depth) +
                     clock_line(facts) + gaps_line(facts);
  for (const std::string& attachment : facts.attachments) text += named("attached: ", attachment);
  std::string tail;
  for (const std::string& note : notes_on(facts)) tail += "note: " + program::escaped(note) + "\n";
  for (const std::string& damage : facts.damages) tail += "damage: " + program::escaped(damage) + "\n";
  return text + "\nlost: messages that were published, but are not in the file (missing sequence numbers)\n" +
         topic_table(facts) + peer_table(facts) + (tail.empty() ? "" : "\n" + tail);
}

std::string in_json(const SessionFacts& facts) {
  program::Json json;
  json.begin_object();
  json.add("seconds", facts.seconds);
  json.add("messages", facts.messages);
  json.add("chunks", facts.chunks);
  json.add("bytes", facts.bytes);
  for (const auto& [key, text] : {std::pair{"program", &facts.program}, std::pair{"version", &facts.version},
                                  std::pair{"commit", &facts.commit}, std::pair{"source", &facts.source},
                                  std::pair{"recorded_by", &facts.recorded_by}, std::pair{"consent", &facts.consent},
                                  std::pair{"voice_consent", &facts.voice_consent}, std::pair{"depth", &facts.depth}})
    add_text(json, key, *text);
  json.begin_object("recording");
  for (const auto& [key, value] : facts.recording)
    if (!key.empty()) json.add(key, value);
  json.end_object();
  if (facts.clock) {
    json.begin_object("clock");
    json.add("drift_ppm", facts.clock->drift_ppm);
    json.add("largest_step_ms", facts.clock->largest_step_ms);
    json.end_object();
  } else {
    json.add_null("clock");
  }
  add_topics(json, facts);
  add_peers(json, facts);
  add_texts(json, "attachments", facts.attachments);
  add_texts(json, "notes", notes_on(facts));
  add_texts(json, "damages", facts.damages);
  json.add("damages_in_all", facts.damages_in_all);
  json.end_object();
  return std::move(json).finish();
}

}  // namespace telepalp::record
