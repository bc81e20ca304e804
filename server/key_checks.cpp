#include "server/key_checks.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "proto/keys/audit_chain.h"
#include "proto/keys/secret/passphrase.h"
#include "proto/keys/web_certificate.h"
#include "proto/words/counted.h"
#include "server/oidc/hospital_sign_in.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEncrypted = "; its passphrase, which the server asks for when it starts, was not tried";

std::string whose(const keys::KeyFile& key) {
  std::string text = "of " + key.identity.name + " for ";
  for (const std::string& host : key.hosts) text += (host == key.hosts.front() ? "" : ", ") + host;
  return text;
}

Finding check_revoked(const access::Access::Options& options, const keys::KeyFile& key) {
  const Result<access::RevokedFile> revoked = access::Access::read_revoked(options, key);
  if (!revoked) return problem("revoked keys", revoked.error());
  if (revoked->list().contains(key.identity.serial))
    return problem("revoked keys", {.what = "this server's own key is revoked",
                                    .where = revoked->file().string(),
                                    .fix = "make a new key: telepalp-keys server"});
  return good("revoked keys", revoked->file().string() + ": " +
                                  counted(revoked->list().all().size(), "key or token", "keys and tokens"));
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

/// The hospital's provider is asked for its addresses. Nobody is signed in.
Finding check_sign_in(const fs::path& file) {
  constexpr const char* kWhat = "hospital's log-in";
  const Result<oidc::Settings> settings = oidc::read_settings(file);
  if (!settings) return problem(kWhat, settings.error());
  if (const Result<void> answers = oidc::check_provider(*settings); !answers) return problem(kWhat, answers.error());
  return good(kWhat, settings->issuer + " answers; it must know the address " + settings->back());
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
  const Result<keys::KeyFile> key = keys::load_key_unasked(options.key, now);
  if (!key) return {problem("key", key.error())};
  if (const Result<void> ours = access::Access::check_is_servers(*key); !ours) return {problem("key", ours.error())};
  Findings found{validity("key", whose(*key), key->identity.expires, now)};
  if (key->private_key == nullptr) found.back().text += kEncrypted;
  found.push_back(check_revoked(options, *key));
  found.push_back(check_audit(options.audit_log(*key)));
  if (!options.web_certificate.empty()) found.push_back(check_web_certificate(options, now));
  if (!asked.sign_in.empty()) found.push_back(check_sign_in(asked.sign_in));
  return found;
}

}  // namespace telepalp::server
