#include "proto/wire/mcap/sealed/sealed_header.h"

#include <algorithm>

#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/sealed/given_key.h"
#include "proto/words/little_endian.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::size_t kCrcAt = kSealedHeaderBytes - sizeof(std::uint32_t);

}  // namespace

std::string SealedHeader::about_block(std::uint64_t number) const {
  std::string about = file_id;
  append_little_endian<std::uint64_t>(about, number);
  return about;
}

Result<SealedHeader> with_key_of(const SealedHeader& header, const keys::SiteKey& site, const keys::FileKey& key) {
  Result<std::string> closed = site.close(key, header.about_key());
  if (!closed) return closed.error();
  return SealedHeader{.site_key_id = site.id(), .file_id = header.file_id, .closed_key = *std::move(closed)};
}

Result<SealedHeader> new_header(const keys::SiteKey& site, const keys::FileKey& key) {
  Result<std::string> id = keys::random_bytes(kFileIdBytes);
  if (!id) return id.error();
  return with_key_of({.site_key_id = {}, .file_id = *std::move(id), .closed_key = {}}, site, key);
}

std::string in_bytes(const SealedHeader& header) {
  std::string bytes = std::string(kSealedMagic) + header.site_key_id + header.file_id;
  append_little_endian<std::uint32_t>(bytes, kSealedBlockBytes);
  bytes += header.closed_key;
  bytes.resize(kCrcAt);
  append_little_endian<std::uint32_t>(bytes, crc32(bytes));
  return bytes;
}

Result<std::optional<SealedHeader>> header_in(std::string_view bytes, const std::string& file) {
  if (!bytes.starts_with(kSealedMagic)) return std::optional<SealedHeader>();
  const Error damaged{.what = "its header is damaged: it is an encrypted session, which cannot be decrypted without it",
                      .where = file,
                      .fix = "replace the file with a copy of the original"};
  if (bytes.size() < kSealedHeaderBytes ||
      get_little_endian<std::uint32_t>(bytes.data() + kCrcAt) != crc32(bytes.substr(0, kCrcAt)))
    return damaged;
  bytes.remove_prefix(kSealedMagic.size());
  const auto take = [&](std::size_t count) {
    std::string part(bytes.substr(0, count));
    bytes.remove_prefix(count);
    return part;
  };
  SealedHeader header{.site_key_id = take(keys::SiteKey::kIdBytes), .file_id = take(kFileIdBytes), .closed_key = {}};
  if (get_little_endian<std::uint32_t>(take(sizeof(std::uint32_t)).data()) != kSealedBlockBytes) return damaged;
  header.closed_key = take(keys::SiteKey::kClosedKeyBytes);
  return std::optional(std::move(header));
}

Result<keys::FileKey> file_key_of(const SealedHeader& header, const std::string& file) {
  const Result<keys::SiteKey> site = given_site_key(header.site_key_id, file);
  if (!site) return site.error();
  return site->open(header.closed_key, header.about_key(), keys::ask_passphrase);
}

}  // namespace telepalp::wire::mcap
