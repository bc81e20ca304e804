#include "proto/wire/mcap/sealed/sealed_text.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/sealed/given_key.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::uint64_t kBlockOfText = std::numeric_limits<std::uint64_t>::max();

}  // namespace

Result<std::string> sealed_text(const keys::SiteKey& site, std::string_view text) {
  const Result<keys::FileKey> key = keys::new_file_key();
  if (!key) return key.error();
  const Result<SealedHeader> header = new_header(site, *key);
  if (!header) return header.error();
  std::string bytes = in_bytes(*header);
  if (keys::seal_block(*key, header->about_block(kBlockOfText), text, bytes)) return bytes;
  return Error{.what = "cannot be encrypted", .where = "OpenSSL", .fix = "give this computer more memory"};
}

Result<std::string> text_of(std::string bytes, const std::string& file) {
  const Result<std::optional<SealedHeader>> header = header_in(bytes, file);
  if (!header) return header.error();
  if (!*header) return bytes;
  const Result<keys::FileKey> key = file_key_of(**header, file);
  if (!key) return key.error();
  std::string text;
  const std::string_view sealed = std::string_view(bytes).substr(kSealedHeaderBytes);
  if (keys::open_block(*key, (**header).about_block(kBlockOfText), sealed, text)) return text;
  return Error{.what = "was altered or cut off, so that it cannot be decrypted",
               .where = file,
               .fix = "replace the file with a copy of the original, or move it away"};
}

Result<std::optional<SealedHeader>> header_of(const std::filesystem::path& file) {
  const Result<std::unique_ptr<ByteSource>> source = open_file(file);
  if (!source) return source.error();
  std::string begin;
  const std::uint64_t size = std::min<std::uint64_t>((*source)->size(), kSealedHeaderBytes);
  if (!(*source)->read(0, static_cast<std::size_t>(size), begin)) begin.clear();
  return header_in(begin, file.string());
}

Result<std::string> text_beside(const std::filesystem::path& session, std::string_view text) {
  std::error_code unknown;
  if (!std::filesystem::exists(session, unknown)) {
    const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
    if (!site_keys) return site_keys.error();
    if (site_keys->empty()) return std::string(text);
    return sealed_text(site_keys->front(), text);
  }
  const Result<std::optional<SealedHeader>> header = header_of(session);
  if (!header) return header.error();
  if (!*header) return std::string(text);
  const Result<keys::SiteKey> site = given_site_key((**header).site_key_id, session.string());
  if (!site) return site.error();
  return sealed_text(*site, text);
}

}  // namespace telepalp::wire::mcap
