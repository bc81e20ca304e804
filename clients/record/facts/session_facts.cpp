#include "clients/record/facts/session_facts.h"

#include <algorithm>

#include "clients/record/facts/session_survey.h"
#include "clients/record/repair/repair.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/reader.h"
#include "proto/words/counted.h"

namespace telepalp::record {
namespace {

double duration_s(const wire::mcap::Statistics& statistics) {
  if (statistics.message_end_time < statistics.message_start_time) return 0.0;
  return static_cast<double>(statistics.message_end_time - statistics.message_start_time) * 1e-9;
}

void note_damage(SessionFacts& facts, std::string what) {
  ++facts.damages_in_all;
  if (facts.damages.size() < kMostDamages) facts.damages.push_back(std::move(what));
}

/// The bound on the error of the depth in the file: the recorder's note at the end of the file or, without it (an
/// encoded or repaired file), the bound in the first image.
std::string depth_of(wire::McapReader& reader, const SessionFacts& facts) {
  if (const auto noted = facts.recording.find("depth"); noted != facts.recording.end()) return noted->second;
  reader.select({.topics = {std::string(wire::kCameraDepth.name)}});
  const auto first = reader.next();
  msg::DepthImage image;
  if (!first || !*first || !image.ParseFromString(*(*first)->payload)) return {};
  return wire::in_words(wire::depth_fidelity(image));
}

/// "repaired from session.mcap: 2 places were damaged, 188 messages are lost".
std::string repair_in_words(const wire::mcap::TextMap& note) {
  const auto value = [&](const char* key) {
    const auto found = note.find(key);
    return found == note.end() ? std::string("unknown") : found->second;
  };
  const std::string from = "repaired from " + value("from") + ": ";
  const std::string lost = value("lost");
  if (lost == "end") return from + "its recorder was interrupted, and the messages of the last moments are missing";
  const auto damages =
      std::ranges::count_if(note, [](const auto& entry) { return entry.first.starts_with("damage_"); });
  const std::string places =
      counted(static_cast<std::uint64_t>(damages), "place was damaged, ", "places were damaged, ");
  if (lost == "unknown") return from + places + "and it is unknown how many messages are lost";
  if (lost == "0") return from + places + "and no message is lost";
  return from + places + "and " + lost + (lost == "1" ? " message is lost" : " messages are lost");
}

void read_notes(wire::McapReader& reader, SessionFacts& facts) {
  for (const wire::mcap::MetadataIndex& index : reader.summary().metadata) {
    const Result<wire::mcap::Metadata> metadata = reader.read(index);
    if (!metadata) note_damage(facts, metadata.error().what);
    if (metadata && index.name == wire::kRecordingMetadata) facts.recording = metadata->values;
    if (metadata && index.name == kRepairMetadata) facts.repairs.push_back(repair_in_words(metadata->values));
  }
  for (const wire::mcap::AttachmentIndex& index : reader.summary().attachments) {
    facts.attachments.push_back(index.name + ", " + std::to_string(index.data_size) + " bytes");
    if (const auto attachment = reader.read(index); !attachment) note_damage(facts, attachment.error().what);
  }
}

Result<void> read_messages(const std::filesystem::path& file, SessionFacts& facts) {
  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  SessionSurvey survey;
  std::uint64_t read = 0;
  for (;;) {
    const auto next = stream->next();
    if (!next) {
      note_damage(facts, next.error().what);
      continue;
    }
    if (!*next) break;
    survey.add(**next);
    ++read;
  }
  if (read != facts.messages)
    note_damage(facts, "the index of the file counts " + counted(facts.messages, "message", "messages") + ", but " +
                           std::to_string(read) + " can be read");
  if (facts.damages_in_all == 0)
    if (const Result<void> checked = stream->check_bytes(is_of_telepalp(*stream)); !checked)
      note_damage(facts, checked.error().what);
  survey.finish(facts);
  for (const SessionFacts::Topic& topic : facts.topics)
    if (topic.unreadable > 0)
      note_damage(facts, topic.name + ": " + counted(topic.unreadable, "message is", "messages are") +
                             " damaged, or not of the type " + topic.type);
  return {};
}

}  // namespace

Result<SessionFacts> inspect(const std::filesystem::path& file) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  const auto bytes = wire::mcap::open_session(file);
  const wire::mcap::Summary& summary = reader->summary();
  SessionFacts facts;
  facts.seconds = duration_s(summary.statistics);
  facts.messages = summary.statistics.message_count;
  facts.chunks = summary.chunks.size();
  facts.bytes = bytes ? (*bytes)->size() : 0;
  facts.program = session->program;
  facts.version = session->version;
  facts.commit = session->commit;
  facts.source = session->source;
  facts.recorded_by = session->recorded_by;
  facts.consent = session->consent;
  facts.voice_consent = session->voice_consent;
  read_notes(*reader, facts);
  facts.depth = depth_of(*reader, facts);
  if (const Result<void> read = read_messages(file, facts); !read) return read.error();
  return facts;
}

std::vector<std::string> notes_on(const SessionFacts& facts) {
  std::vector<std::string> notes = facts.repairs;
  for (const SessionFacts::Topic& topic : facts.topics) {
    if (!topic.is_ours)
      notes.push_back(topic.name + ": the topic or its type is not telepalp's; its messages are not checked");
    if (topic.has_other_version)
      notes.push_back(topic.name + ": recorded by another version of telepalp; its messages may have other fields");
    if (topic.lost > 0)
      notes.push_back(topic.name + ": " + counted(topic.lost, "message is", "messages are") +
                      " missing: lost between publisher and file");
    if (!topic.begins_with_key_frame)
      notes.push_back(topic.name +
                      ": begins with a predicted frame, so that nothing can be decoded before the next "
                      "key frame");
    if (topic.back_in_time > 0)
      notes.push_back(topic.name + ": " +
                      counted(topic.back_in_time, "message has an earlier time than the message before it",
                              "messages have an earlier time than the message before them"));
  }
  for (const auto& [key, value] : facts.recording)
    if (key.starts_with("dropped/"))
      notes.push_back(key.substr(7) + ": the recorder dropped " + value + (value == "1" ? " message" : " messages") +
                      ", because its disk was slow or full");
  return notes;
}

}  // namespace telepalp::record
