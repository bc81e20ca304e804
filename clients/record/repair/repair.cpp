#include "clients/record/repair/repair.h"

#include <algorithm>

#include "clients/record/repair/definitions.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/counted.h"
#include "support/program/version.h"

namespace telepalp::record {
namespace {

constexpr std::size_t kMaxDamagesListed = 100;

/// Reads all of `stream`, gives each message to `take` and notes each damage.
template <class Take>
Result<void> read_all(wire::McapStreamReader& stream, std::vector<std::string>& damages, Take take) {
  for (;;) {
    const auto next = stream.next();
    if (!next) {
      if (damages.size() < kMaxDamagesListed) damages.push_back(next.error().what);
      continue;
    }
    if (!*next) return {};
    if (const Result<void> taken = take(**next); !taken) return taken;
  }
}

struct Survey {
  std::uint64_t messages = 0;
  bool is_cut_off = false;  // the end of the data is missing, and with it the CRC
  bool has_index = false;
  std::optional<std::uint64_t> stored;  // number of messages that were written to the file; nullopt: not known
  std::vector<std::string> damages;
  std::vector<std::string> unplaced;  // of these, those that copying does not meet again
  wire::SessionInfo session;
};

wire::SessionInfo session_of(const std::vector<wire::mcap::Metadata>& metadata) {
  for (const wire::mcap::Metadata& record : metadata)
    if (record.name == wire::kSessionMetadata) return wire::session_info(record);
  return {.program = "telepalp-record repair",
          .version = program::version(),
          .commit = program::commit(),
          .source = {},
          .scene = {}};
}

/// Damage that no single record shows: the file's CRC shows it. Where the file's end is missing, the check sum of the
/// session's metadata shows it, or a definition that differs from this program's own.
std::vector<std::string> unplaced_damages(wire::McapStreamReader& stream, const wire::SessionInfo& session) {
  if (!stream.complete()) {
    std::vector<std::string> damages = DefinitionCheck(session).damaged(stream.channels());
    for (const wire::mcap::Metadata& record : stream.metadata())
      if (!wire::is_intact(record))
        damages.push_back("the metadata " + record.name +
                          " are damaged: who recorded, the consent or the scene may be wrong");
    return damages;
  }
  const Result<void> checked = stream.check_bytes(is_of_telepalp(stream));
  return checked ? std::vector<std::string>{} : std::vector{checked.error().what};
}

Result<Survey> survey(const std::filesystem::path& file) {
  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  Survey found;
  const Result<void> read = read_all(*stream, found.damages, [&](const wire::mcap::StoredMessage&) -> Result<void> {
    ++found.messages;
    return {};
  });
  if (!read) return read.error();
  for (const wire::mcap::RecordHead& head : stream->attachments())
    if (const auto attachment = stream->read(head); !attachment && found.damages.size() < kMaxDamagesListed)
      found.damages.push_back(attachment.error().what);
  found.session = session_of(stream->metadata());
  found.is_cut_off = !stream->complete();
  const Result<wire::McapReader> indexed = wire::McapReader::open(file);
  found.has_index = indexed.ok();
  if (indexed) found.stored = indexed->summary().statistics.message_count;
  // A damaged head can look like a record of a later version, which readers skip: the count of the index shows it.
  if (found.stored && *found.stored != found.messages)
    found.damages.push_back("the index of the file counts " + counted(*found.stored, "message", "messages") + ", but " +
                            std::to_string(found.messages) + " can be read");
  if (found.damages.empty() || found.is_cut_off) found.unplaced = unplaced_damages(*stream, found.session);
  found.damages.insert(found.damages.end(), found.unplaced.begin(), found.unplaced.end());
  if (found.damages.empty() && !found.is_cut_off) found.stored = found.messages;
  return found;
}

/// Copies the readable messages; in a file without its CRC, this program's own definitions replace damaged ones.
Result<void> copy_messages(wire::McapStreamReader& stream, wire::McapWriter& writer, const Survey& found,
                           RepairReport& report) {
  std::optional<DefinitionCheck> definitions;
  if (found.is_cut_off) definitions.emplace(found.session);
  return read_all(stream, report.damages, [&](const wire::mcap::StoredMessage& message) {
    ++report.messages;
    const wire::mcap::StoredChannel* const own = definitions ? definitions->mended(*message.channel) : nullptr;
    return writer.copy({own != nullptr ? own : message.channel, message.record});
  });
}

Result<void> copy_attachments(wire::McapStreamReader& stream, wire::McapWriter& writer,
                              std::vector<std::string>& damages) {
  for (const wire::mcap::RecordHead& head : stream.attachments()) {
    const Result<wire::mcap::Attachment> attachment = stream.read(head);
    if (!attachment) {
      damages.push_back(attachment.error().what);
      continue;
    }
    if (const Result<void> added = writer.add(*attachment); !added) return added;
  }
  return {};
}

std::string lost_in(const RepairReport& report) {
  if (report.lost) return std::to_string(*report.lost);
  return report.only_end_is_missing ? "end" : "unknown";
}

Result<void> copy_metadata(const wire::McapStreamReader& stream, wire::McapWriter& writer,
                           const std::filesystem::path& original, const RepairReport& report) {
  for (const wire::mcap::Metadata& record : stream.metadata())
    if (record.name != wire::kSessionMetadata)
      if (const Result<void> added = writer.add(record); !added) return added;
  wire::mcap::Metadata note{std::string(kRepairMetadata),
                            {{"from", original.filename().string()}, {"lost", lost_in(report)}}};
  for (std::size_t number = 0; number < report.damages.size(); ++number)
    note.values["damage_" + std::to_string(number)] = report.damages[number];
  return writer.add(note);
}

}  // namespace

bool is_of_telepalp(const wire::McapStreamReader& stream) {
  return std::ranges::any_of(stream.metadata(), [](const auto& one) { return one.name == wire::kSessionMetadata; });
}

std::filesystem::path repaired_name(const std::filesystem::path& file) {
  std::string name = file.string();
  if (name.ends_with(kPartial)) name.resize(name.size() - kPartial.size());
  return std::filesystem::path(name).replace_extension(".repaired.mcap");
}

Result<RepairReport> repair(const std::filesystem::path& file, const std::filesystem::path& out) {
  const Result<Survey> found = survey(file);
  if (!found) return found.error();
  if (found->damages.empty() && found->has_index)
    return RepairReport{.was_whole = true, .file = file, .messages = found->messages, .damages = {}, .lost = 0};
  if (found->messages == 0)
    return Error{.what = "holds no message that could be recovered", .where = file.string(), .fix = "record again"};

  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, found->session);
  if (!writer) return writer.error();
  RepairReport report{.was_whole = false, .file = out, .messages = 0, .damages = found->unplaced};
  Result<void> copied = copy_messages(*stream, *writer, *found, report);
  if (copied) copied = copy_attachments(*stream, *writer, report.damages);
  if (found->stored) report.lost = *found->stored - std::min(*found->stored, report.messages);
  report.only_end_is_missing = !found->stored && stream->cut_off() && report.damages.size() == 1;
  if (copied) copied = copy_metadata(*stream, *writer, file, report);
  copied = writer->finish(copied);
  if (!copied) return copied.error();
  return report;
}

std::string recovered(const RepairReport& report) {
  const std::string messages = counted(report.messages, "message", "messages");
  if (!report.lost && report.only_end_is_missing) return messages + "; the end of the file is missing";
  if (!report.lost) return messages + "; the file has no index, so it is unknown how many are lost";
  if (*report.lost == 0) return "all " + messages;
  return std::to_string(report.messages) + " of " + counted(report.messages + *report.lost, "message", "messages") +
         "; " + std::to_string(*report.lost) + (*report.lost == 1 ? " is lost" : " are lost");
}

}  // namespace telepalp::record
