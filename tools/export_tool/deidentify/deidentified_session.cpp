#include "tools/export_tool/deidentify/deidentified_session.h"

#include <string_view>
#include <utility>

#include "proto/wire/camera/color_message.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/writer.h"
#include "support/program/version.h"
#include "tools/export_tool/deidentify/color_mosaic.h"
#include "tools/export_tool/deidentify/text_rules.h"

namespace telepalp::export_tool {
namespace {

std::string if_has_form(const std::string& text, const char* pattern) {
  return has_form(text, std::regex(pattern)) ? text : "";
}

/// The session's own metadata: programs and versions stay; the scene stays without names, files and comments.
wire::SessionInfo cleaned(const wire::SessionInfo& session, MessageCleaner& cleaner) {
  return {.program = if_has_form(session.program, "telepalp-[a-z]+"),
          .version = if_has_form(session.version, "[0-9]+(\\.[0-9]+)*"),
          .commit = if_has_form(session.commit, "[0-9a-f]+"),
          .source = {},
          .scene = cleaner.cleaned_scene(session.scene)};
}

/// Keeps the numbers in a record about a recording or its repair, and the recorder's text about the error of the depth.
wire::mcap::Metadata cleaned(const wire::mcap::Metadata& metadata) {
  static const std::regex kCount("gaps|gap_s|lost|clock_uncertainty_us|dropped/[a-z/]+");
  static const std::regex kNumber("[0-9]+(\\.[0-9]+)?");
  static const std::regex kDepth(
      "(fast|intra|temporal|bounded), (lossless|off by (an unknown amount|up to [0-9.e+-]+ mm at 1 m))");
  wire::mcap::Metadata kept{metadata.name, {}};
  for (const auto& [key, value] : metadata.values)
    if ((has_form(key, kCount) && has_form(value, kNumber)) || (key == "depth" && has_form(value, kDepth)))
      kept.values.emplace(key, value);
  return kept;
}

/// Writes the messages of a session to its copy, cleaned.
class Copy {
 public:
  Copy(wire::McapWriter& writer, ColorRule color, MessageCleaner& cleaner, Deidentified& report)
      : writer_(writer), color_(color), cleaner_(cleaner), report_(report) {}

  Result<void> add(const wire::mcap::StoredMessage& stored) {
    const std::optional<wire::Message> message = to_message(stored);
    Deidentified::Messages& count = report_.topics[message ? std::string(message->topic.name) : kOtherTopics];
    const bool removes_color = color_ == ColorRule::Remove;
    if (!message || message->topic.spoken || (removes_color && wire::carries_color(message->topic))) {
      ++count.removed;
      return {};
    }
    std::optional<std::string> payload = cleaner_.cleaned(message->topic, *message->payload);
    bool key_frame = message->key_frame;
    if (payload && wire::carries_color(message->topic)) {
      wire::Message clean = *message;
      clean.payload = std::make_shared<const std::string>(std::move(*payload));
      std::optional<BlurredColor> blurred = blur_.blurred(clean);
      payload = blurred ? std::optional(std::move(blurred->payload)) : std::nullopt;
      key_frame = blurred && blurred->key_frame;
      count.blurred += blurred ? 1 : 0;
    }
    ++(payload ? count.kept : count.unreadable);
    return payload ? write(stored, message->topic, *payload, key_frame) : Result<void>{};
  }

 private:
  /// Writes under telepalp's own channel and type of the topic: those in the file may hold any text.
  Result<void> write(const wire::mcap::StoredMessage& stored, const wire::Topic& topic, const std::string& payload,
                     bool key_frame) {
    wire::mcap::Schema& schema = schemas_[topic.name];
    if (schema.name.empty()) schema = wire::mcap::schema_of(topic);
    const wire::mcap::StoredChannel channel{.channel = wire::mcap::channel_for(topic, key_frame),
                                            .schema = &schema,
                                            .topic = topic,
                                            .key_frames = key_frame};
    wire::mcap::MessageRecord record = stored.record;
    record.data = payload;
    return writer_.copy({.channel = &channel, .record = record});
  }

  wire::McapWriter& writer_;
  ColorRule color_;
  MessageCleaner& cleaner_;
  Deidentified& report_;
  ColorBlur blur_;
  std::map<std::string_view, wire::mcap::Schema> schemas_;  // by topic, because each holds a serialised type
};

Result<void> copy_messages(wire::McapReader& reader, Copy& copy, Deidentified& report) {
  for (;;) {
    const auto next = reader.next_stored();
    if (!next) {
      ++report.damaged;
      continue;
    }
    if (!*next) return {};
    if (const Result<void> added = copy.add(**next); !added) return added;
  }
}

Result<void> copy_metadata(wire::McapReader& reader, wire::McapWriter& writer, Deidentified& report) {
  report.attachments = reader.summary().attachments.size();
  for (const wire::mcap::MetadataIndex& index : reader.summary().metadata) {
    if (index.name == wire::kSessionMetadata) continue;
    const bool has_numbers = index.name == wire::kRecordingMetadata || index.name == "telepalp.repair";
    const Result<wire::mcap::Metadata> metadata = reader.read(index);
    const wire::mcap::Metadata clean = has_numbers && metadata ? cleaned(*metadata) : wire::mcap::Metadata{};
    if (clean.values.empty()) {
      ++report.records_of_metadata;
      continue;
    }
    if (const Result<void> added = writer.add(clean); !added) return added;
  }
  return {};
}

wire::mcap::Metadata note_of(ColorRule color) {
  return {"telepalp.deidentified",
          {{"program", program::software("telepalp-export")},
           {"color", color == ColorRule::Remove ? "removed" : "blurred"},
           {"dates", "as recorded"}}};
}

}  // namespace

Result<Deidentified> write_deidentified(const std::filesystem::path& file, const std::filesystem::path& out,
                                        ColorRule color) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> session = reader->session();
  if (!session) return session.error();
  Deidentified report;
  const Result<msg::SessionNotes> notes = wire::read_notes(file, {});
  report.notes = notes ? static_cast<std::uint64_t>(notes->notes_size()) : 0;
  MessageCleaner cleaner;
  const wire::SessionInfo clean = cleaned(*session, cleaner);
  report.scene_removed = !session->scene.empty() && clean.scene.empty();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, clean, {}, wire::mcap::Protection::None);
  if (!writer) return writer.error();
  Copy copy(*writer, color, cleaner, report);
  Result<void> written = copy_metadata(*reader, *writer, report);
  if (written) written = writer->add(note_of(color));
  if (written) written = copy_messages(*reader, copy, report);
  if (written = writer->finish(written); !written) return written.error();
  report.texts = cleaner.texts();
  return report;
}

}  // namespace telepalp::export_tool
