#include "clients/record/store/reseal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/sealed/sealed_header.h"

namespace telepalp::record {
namespace {

using wire::mcap::SealedHeader;

Result<SealedHeader> header_of(const std::filesystem::path& file) {
  const Result<std::unique_ptr<wire::mcap::ByteSource>> source = wire::mcap::open_file(file);
  if (!source) return source.error();
  std::string begin;
  const std::uint64_t size = std::min<std::uint64_t>((*source)->size(), wire::mcap::kSealedHeaderBytes);
  if (!(*source)->read(0, static_cast<std::size_t>(size), begin)) begin.clear();
  Result<std::optional<SealedHeader>> header = wire::mcap::header_in(begin, file.string());
  if (!header) return header.error();
  if (*header) return **std::move(header);
  return Error{.what = "is not encrypted",
               .where = file.string(),
               .fix = "telepalp-record copy " + file.string() + " --out NEW.mcap makes an encrypted copy"};
}

/// Replaces the header in one write within one sector of the disk, which a power failure does not cut in two.
Result<void> replace_header(const std::filesystem::path& file, const std::string& bytes) {
  const auto failed = [&](int code) {
    return Error{.what = std::string("its header cannot be written: ") + std::strerror(code),
                 .where = file.string(),
                 .fix = "check the file's permissions and its disk"};
  };
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return failed(errno);
  const bool written = ::pwrite(descriptor, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) &&
                       ::fsync(descriptor) == 0;
  const int code = errno;
  ::close(descriptor);
  return written ? Result<void>{} : Result<void>(failed(code));
}

}  // namespace

Result<Resealed> reseal(const std::filesystem::path& file) {
  const Result<SealedHeader> header = header_of(file);
  if (!header) return header.error();
  const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
  if (!site_keys) return site_keys.error();
  if (site_keys->empty())
    return Error{.what = "no key of a site is given",
                 .where = "TELEPALP_SITE_KEYS",
                 .fix = "name the new key and then the old ones: TELEPALP_SITE_KEYS=NEW.pub:OLD.key"};
  if (site_keys->front().id() == header->site_key_id) return Resealed::HadIt;
  const Result<keys::FileKey> key = wire::mcap::file_key_of(*header, file.string());
  if (!key) return key.error();
  const Result<SealedHeader> changed = wire::mcap::with_key_of(*header, site_keys->front(), *key);
  if (!changed) return changed.error();
  if (const Result<void> replaced = replace_header(file, wire::mcap::in_bytes(*changed)); !replaced)
    return replaced.error();
  return Resealed::Changed;
}

}  // namespace telepalp::record
