#include "server/access/access.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <utility>

#include "proto/keys/audit_chain.h"
#include "proto/keys/audit_text.h"
#include "proto/keys/token.h"
#include "proto/words/counted.h"
#include "proto/words/numbers/utc_text.h"

namespace telepalp::access {
namespace {

namespace fs = std::filesystem;

const std::string kBrowserOf = "browser-of-token-";
const std::string kListNumber = "revocation-list";
const std::string kTouch = "touch";

std::uint64_t number_in(const std::optional<std::string>& text) {
  std::uint64_t number = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), number);
  return number;
}

Error is_sent_out(const keys::Identity& who) {
  return error_without_place("the technician has sent " + describe(who) + " out", "ask the technician to let you in");
}

keys::Identity local() {
  return {.name = "local", .role = keys::Role::Local, .serial = {}, .expires = keys::WallTime::max()};
}

Result<KeptFacts> kept_beside(const fs::path& audit_log) {
  return KeptFacts::open(audit_log.parent_path() / "telepalp.state");
}

RevokedFile revoked_file(const Access::Options& options, const keys::KeyFile& key) {
  return {options.revoked.empty() ? key.path.parent_path() / "revoked.crl" : options.revoked, key.authority};
}

}  // namespace

std::string host_of(const std::string& peer) { return peer.substr(0, peer.rfind(':')); }

std::shared_ptr<Access> Access::without_keys() { return std::shared_ptr<Access>(new Access()); }

Result<std::shared_ptr<Access>> Access::with_key(Options options) {
  std::shared_ptr<Access> access(new Access());
  access->say_ = options.say ? options.say : [](const std::string&) {};
  if (const Result<void> opened = access->open_key(options); !opened) return opened.error();
  if (const Result<void> opened = access->open_web(options); !opened) return opened.error();
  const fs::path log = options.audit_log(*access->key_);
  Result<KeptFacts> kept = kept_beside(log);
  if (!kept) return kept.error();
  access->kept_ = std::move(kept).value();
  access->revoked_ = revoked_file(options, *access->key_);
  if (const Result<void> read = access->read_revocations(); !read) return read.error();
  if (access->is_revoked()) return access->own_key_is_revoked();
  if (const Result<void> audit = access->open_audit(log); !audit) return audit.error();
  access->touch_.restore(access->kept_->get(kTouch).value_or(""), std::chrono::steady_clock::now());
  return access;
}

fs::path Access::Options::audit_log(const keys::KeyFile& opened) const {
  return audit.empty() ? opened.path.parent_path() / "audit.log" : audit;
}

Result<void> Access::check_is_servers(const keys::KeyFile& key) {
  if (key.kind == keys::KeyFile::Kind::Server) return {};
  return Error{.what = "this is the key of a person, not of a server",
               .where = key.path.string(),
               .fix = "make a server's key: telepalp-keys server --host NAME-OR-ADDRESS-OF-THIS-SERVER"};
}

Result<RevokedFile> Access::read_revoked(const Options& options, const keys::KeyFile& key) {
  const Result<KeptFacts> kept = kept_beside(options.audit_log(key));
  if (!kept) return kept.error();
  RevokedFile revoked = revoked_file(options, key);
  if (const Result<void> read = revoked.read(number_in(kept->get(kListNumber))); !read) return read.error();
  return revoked;
}

Result<void> Access::open_audit(const fs::path& log) {
  anchors_.emplace(log, *key_, say_);
  auto audit = AuditLog::open(log, say_, AuditLog::kMostBytes, anchors_->at_start());
  if (!audit) return audit.error();
  audit_ = std::move(audit).value();
  if (const std::string why = alarm(); !why.empty()) note_own(AuditEvent::Damaged, "why=" + keys::audit_text(why));
  return {};
}

Result<void> Access::open_key(const Options& options) {
  Result<keys::KeyFile> key = keys::load_key(options.key, std::chrono::system_clock::now());
  if (!key) return key.error();
  if (const Result<void> ours = check_is_servers(*key); !ours) return ours;
  // weak: the settings are a member of this object
  const auto is_revoked = [self = weak_from_this()](const keys::Identity& who) {
    const std::shared_ptr<Access> access = self.lock();
    if (access && !access->revoked_.list().contains(who.serial)) return false;
    if (access) access->note(AuditEvent::Refused, who, "why=\"its key is revoked\"");
    return true;
  };
  Result<wire::TlsSettings> tls = wire::tls_settings(keys::server_context(*key, is_revoked));
  if (!tls) return tls.error();
  Result<wire::TlsSettings> web = wire::tls_settings(keys::web_server_context(*key));
  if (!web) return web.error();
  tls_ = std::move(tls).value();
  web_tls_ = std::move(web).value();
  key_ = std::make_shared<const keys::KeyFile>(std::move(key).value());
  return {};
}

Result<void> Access::open_web(const Options& options) {
  if (options.web_certificate.empty()) return {};
  web_file_.emplace(options.web_certificate, options.web_key);
  const Result<keys::WebCertificate> read = web_file_->read(keys::ask_passphrase);
  if (!read) return read.error();
  Result<wire::TlsSettings> web = wire::tls_settings(keys::web_server_context(*read));
  if (!web) return web.error();
  web_tls_ = std::move(web).value();
  say_("browsers see the certificate of " + read->hosts.front() + ", valid until " + keys::in_words(read->expires));
  return {};
}

/// A hospital renews its certificates by itself. New connections see the new one; the old one stays while the new one
/// cannot be read.
void Access::look_at_web_certificate() {
  if (!web_file_ || !web_file_->has_changed()) return;
  const Result<keys::WebCertificate> read = web_file_->read(keys::passphrase_of_environment);
  Result<wire::TlsSettings> web =
      read ? wire::tls_settings(keys::web_server_context(*read)) : Result<wire::TlsSettings>(read.error());
  if (!web) return say_("the old web certificate stays: " + to_string(web.error()));
  web_tls_ = std::move(web).value();
  say_("a new web certificate was read, valid until " + keys::in_words(read->expires));
}

std::vector<std::string> Access::web_hosts() const {
  std::vector<std::string> all = web_file_ ? web_file_->hosts() : std::vector<std::string>{};
  all.insert(all.end(), hosts().begin(), hosts().end());
  return all;
}

const std::vector<std::string>& Access::hosts() const {
  static const std::vector<std::string> kNone;
  return key_ ? key_->hosts : kNone;
}

Result<keys::Identity> Access::who(const Shown& shown) {
  if (!has_keys()) return local();
  if (is_revoked()) return own_key_is_revoked();
  if (!shown.is_sealed)
    return error_without_place("this server accepts only TLS connections with a key",
                               "give --key FILE; the technician of the server makes it: telepalp-keys client");
  if (shown.certificate) {
    if (people_.is_sent_out(shown.certificate->serial, std::chrono::steady_clock::now()))
      return is_sent_out(*shown.certificate);
    return *shown.certificate;
  }
  if (shown.token.empty())
    return error_without_place("the client sent no key",
                               "give --key FILE; the technician of the server makes it: telepalp-keys client");
  return read(shown.token, shown.address, shown.proof);
}

Result<keys::Identity> Access::read(std::string_view token, const std::string& address, const keys::TokenProof& proof) {
  const auto now = std::chrono::steady_clock::now();
  if (!key_)
    return error_without_place("this server has no keys, so it checks no token",
                               "open this server's web page without a token");
  if (is_revoked()) return own_key_is_revoked();
  const std::string tried = keys::sha256_hex(token);
  if (!back_off_.may_try(address, tried, now))
    return error_without_place("this token was wrong too often, or too many wrong tokens came from " + address,
                               "wait a minute, then try again");
  Result<keys::Identity> identity = keys::read_token(token, key_->authority, std::chrono::system_clock::now(), proof);
  if (identity && revoked_.list().contains(identity->serial)) {
    note(AuditEvent::Refused, *identity, "why=\"its token is revoked\" from=" + address);
    identity = error_without_place("the token of " + describe(*identity) + " is revoked",
                                   "ask the technician for a new one: telepalp-keys token");
  }
  if (identity && people_.is_sent_out(identity->serial, now)) return is_sent_out(*identity);
  if (identity)
    back_off_.succeeded(address, tried, now);
  else
    back_off_.failed(address, tried, now);
  return identity;
}

Result<keys::Identity> Access::bearer(std::string_view token, const std::string& address) {
  Result<keys::Identity> who = read(token, address, {});
  if (!who || !kept_->get(kBrowserOf + who->serial)) return who;
  note(AuditEvent::Refused, *who, "why=\"a browser has signed in with this token\" from=" + address);
  return error_without_place(
      "a browser has signed in with the token of " + describe(*who) + ", so no program may use it",
      "ask the technician for a token of its own for this program: telepalp-keys token");
}

Result<keys::Identity> Access::sign_in(std::string_view token, const std::string& address, std::string_view cookie) {
  Result<keys::Identity> who = read(token, address, {});
  if (!who) return who;
  const std::optional<std::string> browser = kept_->get(kBrowserOf + who->serial);
  if (!browser || (!cookie.empty() && *browser == keys::sha256_hex(cookie))) return who;
  note(AuditEvent::Refused, *who, "why=\"another browser has signed in with this token\" from=" + address);
  return error_without_place(
      "another browser has signed in with the token of " + describe(*who) + ", or this browser's cookies were deleted",
      "ask the technician for a new token: telepalp-keys token; and to revoke this one if you never used it");
}

void Access::bind_to_browser(const keys::Identity& who, std::string_view cookie) {
  if (!kept_ || kept_->set(kBrowserOf + who.serial, keys::sha256_hex(cookie))) return;
  say_(
      "ALARM: the file telepalp.state beside the audit log cannot be written: after a restart another browser could "
      "use "
      "the token of " +
      describe(who) + ". fix: free space on its disk, or check the disk");
}

Error Access::own_key_is_revoked() const {
  return {.what = "the key of this server is revoked",
          .where = key_->identity.serial,
          .fix = "make a new key: telepalp-keys server --host NAME-OR-ADDRESS-OF-THIS-SERVER"};
}

Result<void> Access::may(const keys::Identity& who, keys::Operation operation) const {
  if (keys::allows(who.role, operation)) return {};
  return error_without_place("the role " + std::string(keys::name(who.role)) + " of " + who.name +
                                 " lacks the right '" + std::string(keys::name(operation)) + "'",
                             "use a key whose role allows it; `telepalp-keys show FILE` tells what a key allows");
}

std::optional<Error> Access::why_over(const keys::Identity& who) const {
  if (!has_keys()) return std::nullopt;
  if (is_revoked()) return own_key_is_revoked();
  if (people_.is_sent_out(who.serial, std::chrono::steady_clock::now())) return is_sent_out(who);
  if (who.expires <= std::chrono::system_clock::now())
    return error_without_place("the key of " + describe(who) + " has expired",
                               "ask the technician to renew it: telepalp-keys renew FILE");
  if (revoked_.list().contains(who.serial))
    return error_without_place("the key of " + describe(who) + " is revoked",
                               "ask the technician for a key: telepalp-keys client --name NAME --role ROLE");
  return std::nullopt;
}

Result<void> Access::read_revocations() {
  if (const Result<void> read = revoked_.read(number_in(kept_->get(kListNumber))); !read) return read;
  kept_->set(kListNumber, std::to_string(revoked_.list().number()));
  return {};
}

void Access::look_at_files() {
  look_at_anchor(false);
  look_at_web_certificate();
  look_at_revocations();
}

void Access::look_at_revocations() {
  if (!has_keys() || !revoked_.has_changed()) return;
  const Result<void> read = read_revocations();
  if (read) {
    unread_said_.clear();
    if (is_revoked() && own_key_revoked_) std::exchange(own_key_revoked_, nullptr)(own_key_is_revoked());
    return say_("the revocation list was read: it revokes " +
                counted(revoked_.list().all().size(), "key or token", "keys and tokens"));
  }
  Error unread = read.error();
  unread.what += "; the previous list stays valid";
  if (std::string text = to_string(unread); text != unread_said_) say_(unread_said_ = std::move(text));
}

void Access::note(AuditEvent event, const std::optional<keys::Identity>& who, const std::string& text) {
  counts_.refused += event == AuditEvent::Refused ? 1 : 0;
  counts_.joined += event == AuditEvent::Joined ? 1 : 0;
  if (!audit_) return;
  const std::string serial = who ? who->serial : "";
  audit_->note(event, serial,
               "who=" + (who ? describe(*who) : "stranger") + (text.empty() ? "" : " " + text) +
                   (serial.empty() ? "" : " key=" + serial),
               std::chrono::system_clock::now());
}

void Access::note_own(AuditEvent event, const std::string& text) {
  if (!audit_) return;
  audit_->note(event, std::nullopt, text, std::chrono::system_clock::now());
  look_at_anchor(event == AuditEvent::Started || event == AuditEvent::Stopped);
}

void Access::look_at_anchor(bool always) {
  if (audit_) anchors_->look(audit_->position(), std::chrono::system_clock::now(), always);
}

std::uint64_t Access::enter(const keys::Identity& who, const std::string& program, const std::string& from,
                            const std::string& more) {
  note(AuditEvent::Joined, who,
       "program=" + keys::audit_text(program) + " from=" + from + (more.empty() ? "" : " ") + more);
  return people_.enter(
      {.who = who, .program = program, .from = from, .since = utc_stamp(std::chrono::system_clock::now())});
}

void Access::leave(std::uint64_t number, const std::string& more) {
  const std::optional<Present> left = people_.leave(number);
  if (!left) return;
  note(AuditEvent::Left, left->who,
       "program=" + keys::audit_text(left->program) + " from=" + left->from + (more.empty() ? "" : " ") + more);
}

Result<void> Access::send_out(const std::string& serial, const std::string& by) {
  for (const auto& [number, stream] : people_.present()) {
    if (stream.who.serial != serial) continue;
    if (describe(stream.who) == by)
      return error_without_place("you cannot send yourself out", "close this page instead");
    note(AuditEvent::SentOut, stream.who, "by=" + keys::audit_text(by));
    people_.send_out(keys::Identity(stream.who), std::chrono::steady_clock::now());
    return {};
  }
  return error_without_place("nobody with this key sees the patient now",
                             "load the page again: this person has left already");
}

void Access::let_in(const std::string& serial, const std::string& by) {
  for (const keys::Identity& who : people_.sent_out(std::chrono::steady_clock::now()))
    if (who.serial == serial) note(AuditEvent::LetIn, who, "by=" + keys::audit_text(by));
  people_.let_in(serial);
}

Result<void> Access::take_touch_away(const std::string& by) {
  const std::optional<std::string> from = touch_.take_away(std::chrono::steady_clock::now());
  if (!from) return error_without_place("nobody holds the touch", "nothing is to do: no station gives a force");
  note_own(AuditEvent::TookAwayTouch, "from=" + keys::audit_text(*from) + " by=" + keys::audit_text(by));
  keep_touch();
  return {};
}

void Access::keep_touch() {
  if (kept_) kept_->set(kTouch, touch_.kept());
}

Result<void> Access::may_join(const keys::Identity& who) {
  if (!audit_ || audit_->may_join(who.serial, std::chrono::system_clock::now())) return {};
  return error_without_place("the key of " + describe(who) + " connects too often",
                             "wait a minute; then look which program connects again and again with this key");
}

Access::Counts Access::counts() const {
  Counts counts = counts_;
  if (audit_) counts.audit_lines = audit_->lines();
  if (audit_) counts.audit_not_written = audit_->not_written();
  return counts;
}

}  // namespace telepalp::access
