#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/key_file.h"
#include "proto/keys/role.h"
#include "proto/keys/token.h"
#include "proto/wire/tls_stream.h"
#include "proto/words/result.h"
#include "server/access/audit_anchors.h"
#include "server/access/audit_log.h"
#include "server/access/kept_facts.h"
#include "server/access/people.h"
#include "server/access/revoked_file.h"
#include "server/access/token_back_off.h"
#include "server/access/touch_lease.h"
#include "server/access/web_certificate_file.h"

namespace telepalp::access {

/// Decides which peers may connect and what each may do, and owns the audit log. Without a key every peer has the role
/// `local`, and the server listens on loopback alone. Owner: the server's network thread. The listeners for peers and
/// browsers hold this object by shared_ptr; each TLS handshake asks it for revoked keys through a weak_ptr.
class Access : public std::enable_shared_from_this<Access> {
 public:
  struct Options {
    std::filesystem::path key;                      ///< key file that `telepalp-keys server` made
    std::filesystem::path revoked;                  ///< empty: revoked.crl beside the key
    std::filesystem::path audit;                    ///< empty: audit.log beside the key
    std::filesystem::path web_certificate{};        ///< chain that browsers see; empty: the key's own certificate
    std::filesystem::path web_key{};                ///< private key of `web_certificate`
    std::function<void(const std::string&)> say{};  ///< log lines for the technician

    [[nodiscard]] std::filesystem::path audit_log(const keys::KeyFile& opened) const;  ///< `opened`: read from `key`
  };

  [[nodiscard]] static std::shared_ptr<Access> without_keys();
  /// Error: the key is unreadable, expired or a person's; the revocation list is invalid; or the audit log is unusable.
  [[nodiscard]] static Result<std::shared_ptr<Access>> with_key(Options options);

  /// Error: `key` is not that of a server.
  [[nodiscard]] static Result<void> check_is_servers(const keys::KeyFile& key);
  /// The list of revoked keys, as a server with these options and this key reads it when it starts. Error: as for
  /// RevokedFile::read(); or this server has read a newer list.
  [[nodiscard]] static Result<RevokedFile> read_revoked(const Options& options, const keys::KeyFile& key);

  [[nodiscard]] bool has_keys() const noexcept { return key_ != nullptr; }
  /// TLS for stations and recorders; null without keys.
  [[nodiscard]] const wire::TlsSettings& tls() const noexcept { return tls_; }
  /// TLS for browsers; null without keys.
  [[nodiscard]] const wire::TlsSettings& web_tls() const noexcept { return web_tls_; }
  /// Names and addresses under which clients reach this server, from its key.
  [[nodiscard]] const std::vector<std::string>& hosts() const;
  /// As hosts(), for browsers: first those of the web certificate, which may begin with "*.".
  [[nodiscard]] std::vector<std::string> web_hosts() const;
  /// The server's key; null without keys.
  [[nodiscard]] std::shared_ptr<const keys::KeyFile> key() const noexcept { return key_; }

  /// What a peer (not a browser) shows to prove who uses it.
  struct Shown {
    bool is_sealed = false;  ///< it uses TLS
    std::optional<keys::Identity> certificate{};
    std::string_view token{};
    keys::TokenProof proof{};  ///< that the client has the secret of `token`
    std::string address{};     ///< of the peer, without the port
  };
  /// The person behind a peer: named by its certificate, else by its token. Error: no TLS, or neither names a person.
  /// Without keys: always `local`.
  [[nodiscard]] Result<keys::Identity> who(const Shown& shown);

  /// The person whom `token` names, which a program (not a browser) sent over HTTP. Error: the token is not valid, too
  /// many wrong ones came (TokenBackOff), or a browser has signed in with it.
  [[nodiscard]] Result<keys::Identity> bearer(std::string_view token, const std::string& address);
  /// The person who signs in at a browser with `token`. `cookie`: the browser's cookie of an earlier sign-in; empty:
  /// none. Error: the token is not valid, too many wrong ones came (TokenBackOff), or another browser has signed in
  /// with it.
  [[nodiscard]] Result<keys::Identity> sign_in(std::string_view token, const std::string& address,
                                               std::string_view cookie);
  /// From now on `who`'s token signs in only the browser that keeps `cookie`, also after a restart of the server.
  void bind_to_browser(const keys::Identity& who, std::string_view cookie);

  /// Checks that the role of `who` allows `operation`. Each operation is checked where it enters the server.
  [[nodiscard]] Result<void> may(const keys::Identity& who, keys::Operation operation) const;

  /// Why the key of `who` is no longer valid here: the server's own key is revoked, the technician has sent this person
  /// out, or the key has expired or is revoked. nullopt: it is valid.
  [[nodiscard]] std::optional<Error> why_over(const keys::Identity& who) const;
  [[nodiscard]] bool still_holds(const keys::Identity& who) const { return !why_over(who); }

  /// Reads the revocation list and the web certificate again if their files changed, and keeps an anchor of the audit
  /// log when one is due. Call it each second.
  void look_at_files();
  /// The list of revoked keys in PEM, which each client sees; empty without keys.
  [[nodiscard]] const std::string& revocation_list() const noexcept { return revoked_.text(); }
  [[nodiscard]] std::uint64_t revocation_number() const noexcept { return revoked_.list().number(); }
  /// True once the server's own key is revoked: nobody is served any more.
  [[nodiscard]] bool is_revoked() const { return key_ && revoked_.list().contains(key_->identity.serial); }
  /// `ended` is called once, when the server's own key is revoked.
  void on_revoked(std::function<void(const Error& why)> ended) { own_key_revoked_ = std::move(ended); }

  /// Writes to the audit log what `who` did (nullopt: a stranger, whom no key or token names), with the further
  /// fields `text`.
  void note(AuditEvent event, const std::optional<keys::Identity>& who, const std::string& text);
  /// Writes to the audit log what the server did.
  void note_own(AuditEvent event, const std::string& text);

  /// A stream of the patient begins for `who`: a line in the audit log, and a row in people(). `more`: further
  /// fields of the line. Returns the stream's number.
  std::uint64_t enter(const keys::Identity& who, const std::string& program, const std::string& from,
                      const std::string& more);
  /// Stream `number` ends. `more`: further fields of its line in the audit log.
  void leave(std::uint64_t number, const std::string& more);
  [[nodiscard]] const People& people() const noexcept { return people_; }

  /// Technician `by` ends all streams of the key or token `serial` within a second; no new one begins for
  /// People::kSentOut. Error: it has no open stream, or it is `by`'s own.
  [[nodiscard]] Result<void> send_out(const std::string& serial, const std::string& by);
  /// Technician `by` ends the wait that send_out() began.
  void let_in(const std::string& serial, const std::string& by);
  /// Technician `by` takes the touch away from the doctor who holds it. Error: nobody holds it.
  [[nodiscard]] Result<void> take_touch_away(const std::string& by);
  /// Keeps the holder of the touch for a restart of the server. Call it after each change of touch().
  void keep_touch();

  /// The newest anchor of the audit log (AuditAnchors); empty: none yet.
  [[nodiscard]] std::string anchor() const { return anchors_ ? anchors_->newest() : ""; }

  /// Error: the key of `who` has connected so often that its next lines would fill the audit log (LineBudget).
  [[nodiscard]] Result<void> may_join(const keys::Identity& who);
  /// Why the audit log cannot be trusted; empty: it can.
  [[nodiscard]] std::string alarm() const { return audit_ ? audit_->alarm() : ""; }
  [[nodiscard]] TouchLease& touch() noexcept { return touch_; }

  struct Counts {
    std::uint64_t refused = 0;  ///< number of refused keys, tokens, operations and connections
    std::uint64_t joined = 0;
    std::uint64_t audit_lines = 0;
    std::uint64_t audit_not_written = 0;
  };
  [[nodiscard]] Counts counts() const;

 private:
  Access() = default;
  [[nodiscard]] Result<void> open_key(const Options& options);
  [[nodiscard]] Result<void> open_web(const Options& options);
  void look_at_web_certificate();
  void look_at_revocations();
  [[nodiscard]] Result<void> read_revocations();
  [[nodiscard]] Error own_key_is_revoked() const;
  [[nodiscard]] Result<void> open_audit(const std::filesystem::path& log);
  void look_at_anchor(bool always);
  [[nodiscard]] Result<keys::Identity> read(std::string_view token, const std::string& address,
                                            const keys::TokenProof& proof);

  std::shared_ptr<const keys::KeyFile> key_;  // shared with the dialer of the meeting point; null: without keys
  wire::TlsSettings tls_;
  wire::TlsSettings web_tls_;
  std::optional<WebCertificateFile> web_file_;
  RevokedFile revoked_;
  std::string unread_said_;  ///< the last error of the revocation list; the same error is not logged again
  std::optional<KeptFacts> kept_;
  std::function<void(const Error&)> own_key_revoked_;
  TokenBackOff back_off_;
  TouchLease touch_;
  People people_;
  std::unique_ptr<AuditLog> audit_;
  std::optional<AuditAnchors> anchors_;
  std::function<void(const std::string&)> say_;
  Counts counts_;
};

/// "127.0.0.1:4711" -> "127.0.0.1"
[[nodiscard]] std::string host_of(const std::string& peer);

}  // namespace telepalp::access
