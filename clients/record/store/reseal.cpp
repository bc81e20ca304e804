#include "clients/record/store/reseal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/sealed/sealed_header.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "support/program/files/whole_file.h"

namespace telepalp::record {
namespace {

using wire::mcap::SealedHeader;

Result<SealedHeader> encrypted_header(const std::filesystem::path& file) {
  Result<std::optional<SealedHeader>> header = wire::mcap::header_of(file);
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

Result<void> reseal_session(const std::filesystem::path& file, const SealedHeader& header, const keys::SiteKey& site) {
  const Result<keys::FileKey> key = wire::mcap::file_key_of(header, file.string());
  if (!key) return key.error();
  const Result<SealedHeader> changed = wire::mcap::with_key_of(header, site, *key);
  if (!changed) return changed.error();
  return replace_header(file, wire::mcap::in_bytes(*changed));
}

/// Encrypts the notes on `session` for `site`, also if they were not encrypted. Returns false if they were encrypted
/// for it already, or there are none.
Result<bool> reseal_notes(const std::filesystem::path& session, const keys::SiteKey& site) {
  const std::filesystem::path file = wire::notes_file(session);
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return false;
  const Result<std::optional<SealedHeader>> header = wire::mcap::header_of(file);
  if (!header) return header.error();
  if (*header && (**header).site_key_id == site.id()) return false;
  const Result<std::optional<std::string>> text = wire::notes_text(session);
  if (!text) return text.error();
  if (!*text) return false;  // somebody has just removed it
  const Result<std::string> bytes = wire::mcap::sealed_text(site, **text);
  if (!bytes) return bytes.error();
  if (const Result<void> done = program::write_whole_file(file, *bytes, program::Readers::Group); !done)
    return done.error();
  return true;
}

}  // namespace

Result<Resealed> reseal(const std::filesystem::path& file) {
  const Result<SealedHeader> header = encrypted_header(file);
  if (!header) return header.error();
  const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
  if (!site_keys) return site_keys.error();
  if (site_keys->empty())
    return Error{.what = "no key of a site is given",
                 .where = "TELEPALP_SITE_KEYS",
                 .fix = "name the new key and then the old ones: TELEPALP_SITE_KEYS=NEW.pub:OLD.key"};
  const keys::SiteKey& site = site_keys->front();
  const bool had_it = site.id() == header->site_key_id;
  if (!had_it)
    if (const Result<void> done = reseal_session(file, *header, site); !done) return done.error();
  const Result<bool> notes = reseal_notes(file, site);
  if (!notes) return notes.error();
  return had_it && !*notes ? Resealed::HadIt : Resealed::Changed;
}

}  // namespace telepalp::record
