#include "clients/record/repair.h"

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "proto/wire/mcap/writer.h"
#include "proto/words/counted.h"
#include "support/program/version.h"

namespace telepalp::record {
namespace {

constexpr std::string_view kPartial = ".partial";
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
  std::vector<std::string> damages;
  std::vector<std::string> unplaced;  // of these, those that no record shows, so that copying does not meet them
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
  // A damaged head can look like a record of a later version, which readers skip: the count of the index shows it.
  const Result<wire::McapReader> indexed = wire::McapReader::open(file);
  if (indexed && indexed->summary().statistics.message_count != found.messages)
    found.damages.push_back("the index of the file counts " +
                            counted(indexed->summary().statistics.message_count, "message", "messages") + ", but " +
                            std::to_string(found.messages) + " can be read");
  if (found.damages.empty())
    if (const Result<void> checked = stream->check_bytes(); !checked)
      found.damages = found.unplaced = {checked.error().what};
  return found;
}

Result<void> copy_the_rest(wire::McapStreamReader& stream, wire::McapWriter& writer,
                           const std::filesystem::path& original, std::vector<std::string>& damages) {
  for (const wire::mcap::RecordHead& head : stream.attachments()) {
    const Result<wire::mcap::Attachment> attachment = stream.read(head);
    if (!attachment) {
      damages.push_back(attachment.error().what);
      continue;
    }
    if (const Result<void> added = writer.add(*attachment); !added) return added;
  }
  for (const wire::mcap::Metadata& record : stream.metadata())
    if (record.name != wire::kSessionMetadata)
      if (const Result<void> added = writer.add(record); !added) return added;
  wire::mcap::Metadata note{"telepalp.repair", {{"from", original.filename().string()}}};
  for (std::size_t number = 0; number < damages.size(); ++number)
    note.values["damage_" + std::to_string(number)] = damages[number];
  return writer.add(note);
}

}  // namespace

std::filesystem::path repaired_name(const std::filesystem::path& file) {
  std::string name = file.string();
  if (name.ends_with(kPartial)) name.resize(name.size() - kPartial.size());
  return std::filesystem::path(name).replace_extension(".repaired.mcap");
}

Result<RepairReport> repair(const std::filesystem::path& file, const std::filesystem::path& out) {
  const Result<Survey> found = survey(file);
  if (!found) return found.error();
  if (found->damages.empty() && wire::McapReader::open(file))
    return RepairReport{.was_whole = true, .file = file, .messages = found->messages, .damages = {}};
  if (found->messages == 0)
    return Error{.what = "holds no message that could be recovered", .where = file.string(), .fix = "record again"};

  Result<wire::McapStreamReader> stream = wire::McapStreamReader::open(file);
  if (!stream) return stream.error();
  Result<wire::McapWriter> writer = wire::McapWriter::open(out, found->session);
  if (!writer) return writer.error();
  RepairReport report{.was_whole = false, .file = out, .messages = 0, .damages = found->unplaced};
  Result<void> copied = read_all(*stream, report.damages, [&](const wire::mcap::StoredMessage& message) {
    ++report.messages;
    return writer->copy(message.channel->schema, message.channel->channel, message.record);
  });
  if (copied) copied = copy_the_rest(*stream, *writer, file, report.damages);
  copied = writer->finish(copied);
  if (!copied) return copied.error();
  return report;
}

}  // namespace telepalp::record
