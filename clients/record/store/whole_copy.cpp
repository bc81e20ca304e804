#include "clients/record/store/whole_copy.h"

#include <algorithm>
#include <string>

#include "clients/record/store/cluster_terms.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/reader.h"

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

}  // namespace

Result<std::uint64_t> copy_whole(const std::filesystem::path& session, const std::filesystem::path& out,
                                 const WholeCopyOptions& options) {
  Result<wire::McapReader> reader = wire::McapReader::open(session);  // an incomplete session is refused
  if (!reader) return reader.error();
  const Result<wire::SessionInfo> info = reader->session();
  if (!info) return info.error();
  if (session_store::is_in_cluster(out.string())) {
    const auto terms = cluster_terms(info->consent, options.keep, std::chrono::system_clock::now());
    if (!terms) return terms.error();
    session_store::use_cluster_sessions(*terms);
  }
  Result<std::unique_ptr<wire::mcap::ByteSource>> from = wire::mcap::open_session(session);
  if (!from) return from.error();
  Result<wire::mcap::OutputFile> to = wire::mcap::OutputFile::create(out, options.protection);
  if (!to) return to.error();
  Result<void> copied = copy_bytes(**from, *to);
  if (copied) copied = to->publish();
  if (copied) return (*from)->size();
  to->discard();
  return copied.error();
}

}  // namespace telepalp::record
