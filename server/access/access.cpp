#include "server/access/access.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "proto/keys/token.h"
#include "proto/words/counted.h"

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxListBytes = std::uintmax_t{16} << 20;

Error refused(std::string what, std::string fix) {
  return {.what = std::move(what), .where = {}, .fix = std::move(fix)};
}

keys::Identity local() {
  return {.name = "local", .role = keys::Role::Local, .serial = {}, .expires = keys::WallTime::max()};
}

}  // namespace

std::string host_of(const std::string& peer) { return peer.substr(0, peer.rfind(':')); }

std::shared_ptr<Access> Access::without_keys() { return std::shared_ptr<Access>(new Access()); }

Result<std::shared_ptr<Access>> Access::with_key(Options options) {
  std::shared_ptr<Access> access(new Access());
  access->say_ = options.say ? options.say : [](const std::string&) {};
  if (const Result<void> opened = access->open_key(options); !opened) return opened.error();
  const fs::path folder = options.key.parent_path();
  const fs::path beside = folder / "revoked.crl";
  access->revoked_file_ = options.revoked.empty() && fs::exists(beside) ? beside : options.revoked;
  if (access->revoked_file_.empty()) access->revoked_file_ = beside;  // it may come while the server runs
  if (!options.revoked.empty() || fs::exists(beside))
    if (const Result<void> read = access->read_revocations(); !read) return read.error();
  auto audit = AuditLog::open(options.audit.empty() ? folder / "audit.log" : options.audit, access->say_);
  if (!audit) return audit.error();
  access->audit_ = std::move(audit).value();
  return access;
}

Result<void> Access::open_key(const Options& options) {
  Result<keys::KeyFile> key = keys::load_key(options.key, std::chrono::system_clock::now());
  if (!key) return key.error();
  if (key->kind != keys::KeyFile::Kind::Server)
    return Error{.what = "this is the key of a person, not of a server",
                 .where = options.key.string(),
                 .fix = "make a server's key: telepalp-keys server --host NAME-OR-ADDRESS-OF-THIS-SERVER"};
  // weak: the settings are a member of this object
  const auto is_revoked = [self = weak_from_this()](const std::string& serial) {
    const std::shared_ptr<Access> access = self.lock();
    return !access || access->revocations_.contains(serial);
  };
  Result<wire::TlsSettings> tls = wire::tls_settings(keys::server_context(*key, is_revoked));
  if (!tls) return tls.error();
  Result<wire::TlsSettings> web = wire::tls_settings(keys::web_server_context(*key));
  if (!web) return web.error();
  tls_ = std::move(tls).value();
  web_tls_ = std::move(web).value();
  key_ = std::move(key).value();
  return {};
}

const std::vector<std::string>& Access::hosts() const {
  static const std::vector<std::string> kNone;
  return key_ ? key_->hosts : kNone;
}

Result<keys::Identity> Access::who(bool is_sealed, const std::optional<keys::Identity>& certificate,
                                   std::string_view token, const std::string& address) {
  if (!has_keys()) return local();
  if (!is_sealed)
    return refused("this server accepts only TLS connections with a key",
                   "give --key FILE; the technician of the server makes it: telepalp-keys client");
  if (certificate) return *certificate;
  if (token.empty())
    return refused("the client sent no key",
                   "give --key FILE; the technician of the server makes it: telepalp-keys client");
  return bearer(token, address);
}

Result<keys::Identity> Access::bearer(std::string_view token, const std::string& address) {
  const auto now = std::chrono::steady_clock::now();
  if (!key_)
    return refused("this server has no keys, so it checks no token", "open this server's web page without a token");
  if (!back_off_.may_try(address, now))
    return refused("too many wrong tokens came from " + address, "wait a minute, then try again");
  Result<keys::Identity> identity = keys::read_token(token, key_->authority, std::chrono::system_clock::now());
  if (identity && revocations_.contains(identity->serial))
    identity = refused("the token of " + describe(*identity) + " is revoked",
                       "ask the technician for a new one: telepalp-keys token");
  if (identity)
    back_off_.succeeded(address);
  else
    back_off_.failed(address, now);
  return identity;
}

Result<void> Access::may(const keys::Identity& who, keys::Operation operation) const {
  if (keys::allows(who.role, operation)) return {};
  return refused("the role " + std::string(keys::name(who.role)) + " of " + who.name + " lacks the right '" +
                     std::string(keys::name(operation)) + "'",
                 "use a key whose role allows it; `telepalp-keys show FILE` tells what a key allows");
}

bool Access::still_holds(const keys::Identity& who) const {
  return !has_keys() || (who.expires > std::chrono::system_clock::now() && !revocations_.contains(who.serial));
}

Result<void> Access::read_revocations() {
  std::error_code failed;
  const auto changed = fs::last_write_time(revoked_file_, failed);
  const std::uintmax_t size = failed ? 0 : fs::file_size(revoked_file_, failed);
  std::ifstream stream(revoked_file_, std::ios::binary);
  if (failed || !stream || size > kMaxListBytes)
    return Error{.what = "the revocation list cannot be read",
                 .where = revoked_file_.string(),
                 .fix = "copy revoked.crl again from the folder in which telepalp-keys keeps the authority"};
  revoked_read_ = changed;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  Result<keys::Revocations> read = keys::Revocations::read(text, key_->authority, revoked_file_.string());
  if (!read) return read.error();
  revocations_ = std::move(read).value();
  return {};
}

void Access::look_at_revocations() {
  std::error_code failed;
  if (!has_keys()) return;
  const auto changed = fs::last_write_time(revoked_file_, failed);
  if (failed || changed == revoked_read_) return;
  const Result<void> read = read_revocations();
  if (read) {
    unread_said_.clear();
    return say_("the revocation list was read: it revokes " +
                counted(revocations_.all().size(), "key or token", "keys and tokens"));
  }
  Error unread = read.error();
  unread.what += "; the previous list stays valid";
  if (std::string text = to_string(unread); text != unread_said_) say_(unread_said_ = std::move(text));
}

void Access::note(AuditEvent event, const std::string& text) {
  counts_.refused += event == AuditEvent::Refused ? 1 : 0;
  counts_.joined += event == AuditEvent::Joined ? 1 : 0;
  if (audit_) audit_->note(event, text, std::chrono::system_clock::now());
}

Access::Counts Access::counts() const {
  Counts counts = counts_;
  if (audit_) counts.audit_lines = audit_->lines();
  if (audit_) counts.audit_not_written = audit_->not_written();
  return counts;
}

}  // namespace telepalp::access
