#include "clients/record/store/whole_copy.h"

#include <algorithm>
#include <string>

#include "clients/record/store/cluster_terms.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "support/program/files/whole_file.h"

namespace telepalp::record {
namespace {

constexpr std::uint64_t kPiece_B = 1 << 20;

Result<void> copy_bytes(wire::mcap::ByteSource& from, wire::mcap::OutputFile& to) {
  std::string piece;
  for (std::uint64_t at = 0; at < from.size(); at += piece.size()) {
    if (!from.read(at, static_cast<std::size_t>(std::min(kPiece_B, from.size() - at)), piece))
      return Error{.what = "cannot be read from byte " + std::to_string(at) + " on, or is damaged there",
                   .where = from.name(),
                   .fix = "telepalp-record repair " + from.name() + " --out NEW.mcap copies what can be read"};
    if (Result<void> written = to.append(piece); !written) return written;
  }
  return {};
}

/// Notes that another session left behind would become notes on the copy.
Result<void> check_no_notes(const std::filesystem::path& out) {
  std::error_code unknown;
  if (std::filesystem::exists(out, unknown) || !std::filesystem::exists(wire::notes_file(out), unknown)) return {};
  return Error{.what = "exists already: notes on a session that is not here",
               .where = wire::notes_file(out).string(),
               .fix = "choose another name for the copy, or move this file away"};
}

Result<void> write_notes(const std::filesystem::path& out, const std::string& notes,
                         wire::mcap::Protection protection) {
  const bool is_plain = protection == wire::mcap::Protection::None;
  const Result<std::string> bytes = is_plain ? Result<std::string>(notes) : wire::mcap::text_beside(out, notes);
  if (!bytes) return bytes.error();
  return program::write_whole_file(wire::notes_file(out), *bytes, program::Readers::Group);
}

/// Writes `out`, and its notes before it gets its name: a session without its notes would look complete.
Result<void> write_copy(wire::mcap::ByteSource& from, const std::filesystem::path& out, const std::string* notes,
                        wire::mcap::Protection protection) {
  Result<wire::mcap::OutputFile> to = wire::mcap::OutputFile::create(out, protection);
  if (!to) return to.error();
  Result<void> copied = copy_bytes(from, *to);
  if (copied && notes != nullptr) copied = write_notes(out, *notes, protection);
  if (copied) copied = to->publish();
  if (copied) return {};
  to->discard();
  std::error_code ignored;
  if (notes != nullptr) std::filesystem::remove(wire::notes_file(out), ignored);
  return copied;
}

}  // namespace

Result<WholeCopy> copy_whole(const std::filesystem::path& session, const std::filesystem::path& out,
                             const WholeCopyOptions& options) {
  Result<wire::McapReader> reader = wire::McapReader::open(session);  // an incomplete session is refused
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> info = reader->session();
  if (!info) return info.error();
  const Result<std::optional<std::string>> notes = wire::notes_text(session);
  if (!notes) return notes.error();
  const bool to_cluster = session_store::is_in_cluster(out.string());
  if (to_cluster) {
    const auto terms = cluster_terms(info->consent, options.keep, std::chrono::system_clock::now());
    if (!terms) return terms.error();
    session_store::use_cluster_sessions(*terms);
  } else if (Result<void> free = check_no_notes(out); !free) {
    return free.error();
  }
  const Result<std::unique_ptr<wire::mcap::ByteSource>> from = wire::mcap::open_session(session);
  if (!from) return from.error();
  const bool copies_notes = notes->has_value() && !to_cluster;
  if (Result<void> done = write_copy(**from, out, copies_notes ? &**notes : nullptr, options.protection); !done)
    return done.error();
  return WholeCopy{.bytes = (*from)->size(),
                   .notes = copies_notes ? CopiedNotes::Copied
                            : *notes     ? CopiedNotes::LeftOut
                                         : CopiedNotes::None};
}

}  // namespace telepalp::record
