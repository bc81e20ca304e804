#include "proto/wire/mcap/sealed/sealer.h"

#include <algorithm>
#include <vector>

namespace telepalp::wire::mcap {
namespace {

std::uint64_t place_of_block(std::uint64_t number) {
  return kSealedHeaderBytes + number * (kSealedBlockBytes + keys::kSealBytes);
}

}  // namespace

Result<void> Sealer::begin(ByteSink& sink) { return sink.write(0, in_bytes(header_)); }

/// `blocks` as encrypted blocks from `number` on; nullopt: OpenSSL failed.
std::optional<std::string> Sealer::sealed(std::uint64_t number, std::string_view blocks) const {
  std::string bytes;
  for (; !blocks.empty(); ++number) {
    const std::string_view block = blocks.substr(0, kSealedBlockBytes);
    if (!keys::seal_block(key_, header_.about_block(number), block, bytes)) return std::nullopt;
    blocks.remove_prefix(block.size());
  }
  return bytes;
}

Result<void> Sealer::append(ByteSink& sink, std::string_view bytes) {
  std::string content = last_;
  content += bytes;
  const std::optional<std::string> written = sealed(full_, content);
  if (!written)
    return Error{.what = "cannot be encrypted", .where = "OpenSSL", .fix = "give this computer more memory"};
  if (Result<void> done = sink.write(place_of_block(full_), *written); !done) {
    sink.cut(place_of_block(full_));
    if (const std::optional<std::string> before = sealed(full_, last_))
      (void)sink.write(place_of_block(full_), *before);  // there was room for it before
    return done;
  }
  const std::size_t done = content.size() / kSealedBlockBytes;
  full_ += done;
  last_ = content.substr(done * kSealedBlockBytes);
  return {};
}

Result<std::optional<Sealer>> sealer_of_site() {
  const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
  if (!site_keys) return site_keys.error();
  if (site_keys->empty()) return std::optional<Sealer>();
  const Result<keys::FileKey> key = keys::new_file_key();
  if (!key) return key.error();
  Result<SealedHeader> header = new_header(site_keys->front(), *key);
  if (!header) return header.error();
  return std::optional<Sealer>(std::in_place, *std::move(header), *key);
}

}  // namespace telepalp::wire::mcap
