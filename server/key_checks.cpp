#include "server/key_checks.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "proto/keys/audit_chain.h"
#include "proto/keys/secret/passphrase.h"
#include "proto/keys/web_certificate.h"
#include "proto/words/counted.h"
#include "server/access/revoked_file.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEncrypted = "; its passphrase, which the server asks for when it starts, was not tried";

bool has_passphrase() {
  return std::getenv("TELEPALP_PASSPHRASE") != nullptr || std::getenv("TELEPALP_PASSPHRASE_FILE") != nullptr;
}

/// The server's key without its secret if that would need a passphrase which the environment does not give.
Result<keys::KeyFile> read_server_key(const fs::path& file, keys::WallTime now) {
  const Result<std::string> text = keys::read_key_text(file);
  if (!text) return text.error();
  Result<keys::KeyFile> key = keys::read_public_part(*text, file.string());
  if (!key) return key.error();
  if (key->secret == keys::Secret::Plain || has_passphrase())
    return keys::load_key(file, now, keys::passphrase_of_environment);
  if (const Result<void> hidden = keys::check_private(file); !hidden) return hidden.error();
  if (const Result<void> valid = keys::check_not_expired(*key, now, file.string()); !valid) return valid.error();
  return key;
}

std::string whose(const keys::KeyFile& key) {
  std::string text = "of " + key.identity.name + " for ";
  for (const std::string& host : key.hosts) text += (host == key.hosts.front() ? "" : ", ") + host;
  return text;
}

Finding check_revoked(const fs::path& file, const keys::KeyFile& key) {
  access::RevokedFile revoked(file, key.authority);
  if (const Result<void> read = revoked.read(); !read) return problem("revoked keys", read.error());
  if (revoked.list().contains(key.identity.serial))
    return problem("revoked keys", {.what = "this server's own key is revoked",
                                    .where = file.string(),
                                    .fix = "make a new key: telepalp-keys server"});
  return good("revoked keys",
              file.string() + ": " + counted(revoked.list().all().size(), "key or token", "keys and tokens"));
}

/// Error: this program may not write to `file`, or to its folder if there is no such file yet.
Result<void> may_write(const fs::path& file) {
  std::error_code unknown;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::path& looked_at = fs::exists(file, unknown) ? file : folder;
  if (::access(folder.c_str(), W_OK | X_OK) == 0 && ::access(looked_at.c_str(), W_OK) == 0) return {};
  return Error{.what = std::string("cannot be written: ") + std::strerror(errno),
               .where = file.string(),
               .fix = "let the server's user write to this folder, or give another file by --audit"};
}

Finding check_audit(const fs::path& log) {
  if (const Result<void> writable = may_write(log); !writable) return problem("audit log", writable.error());
  std::error_code unknown;
  if (const fs::path damaged = log.string() + ".damaged-1"; fs::exists(damaged, unknown))
    return problem("audit log", {.what = "was altered or cut off",
                                 .where = damaged.string(),
                                 .fix = "compare it with a copy, then move it to another folder"});
  const std::vector<fs::path> files = keys::audit_files(log);
  if (files.empty()) return good("audit log", log.string() + " begins with the server's start");
  keys::AuditVerifier verifier;
  if (const Result<void> whole = verifier.add_file(files.back()); !whole) return problem("audit log", whole.error());
  return good("audit log",
              log.string() + " is whole, " + counted(verifier.position().lines, "line", "lines") + " in all");
}

Finding check_web_certificate(const access::Access::Options& options, keys::WallTime now) {
  constexpr const char* kWhat = "web certificate";
  const auto read =
      keys::load_web_certificate(options.web_certificate, options.web_key, now, keys::passphrase_of_environment);
  if (!read) return problem(kWhat, read.error());
  return validity(kWhat, "of " + read->hosts.front(), read->expires, now);
}

}  // namespace

Finding validity(std::string what, const std::string& whose, keys::WallTime expires, keys::WallTime now) {
  const std::string text = whose + ", valid until " + keys::in_words(expires);
  if (expires - now >= kRenewInTime) return good(std::move(what), text);
  const auto days = std::chrono::duration_cast<std::chrono::days>(expires - now).count();
  return note(std::move(what), text + ": renew it within " +
                                   counted(static_cast<std::uint64_t>(std::max<std::int64_t>(days, 0)), "day", "days"));
}

Findings check_keys(const Asked& asked, keys::WallTime now) {
  if (!asked.keys) return {note("key", "none: only programs on this computer are served, without encryption")};
  const access::Access::Options& options = *asked.keys;
  const Result<keys::KeyFile> key = read_server_key(options.key, now);
  if (!key) return {problem("key", key.error())};
  if (key->kind != keys::KeyFile::Kind::Server)
    return {problem("key", {.what = "this is the key of a person, not of a server",
                            .where = options.key.string(),
                            .fix = "make a server's key: telepalp-keys server"})};
  Findings found{validity("key", whose(*key), key->identity.expires, now)};
  if (key->private_key == nullptr) found.back().text += kEncrypted;
  const fs::path folder = options.key.parent_path();
  found.push_back(check_revoked(options.revoked.empty() ? folder / "revoked.crl" : options.revoked, *key));
  found.push_back(check_audit(options.audit.empty() ? folder / "audit.log" : options.audit));
  if (!options.web_certificate.empty()) found.push_back(check_web_certificate(options, now));
  return found;
}

}  // namespace telepalp::server
