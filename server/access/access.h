#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/key_file.h"
#include "proto/keys/revocations.h"
#include "proto/keys/role.h"
#include "proto/wire/tls_stream.h"
#include "proto/words/result.h"
#include "server/access/audit_log.h"
#include "server/access/token_back_off.h"
#include "server/access/touch_lease.h"

namespace telepalp::access {

/// Decides which peers may connect and what each may do, and owns the audit log. Without a key every peer has the role
/// `local`, and the server listens on loopback alone. Owner: the server's network thread. The listeners for peers and
/// browsers hold this object by shared_ptr; each TLS handshake asks it for revoked keys through a weak_ptr.
class Access : public std::enable_shared_from_this<Access> {
 public:
  struct Options {
    std::filesystem::path key;                      ///< key file that `telepalp-keys server` made
    std::filesystem::path revoked;                  ///< empty: revoked.crl beside the key, if it exists
    std::filesystem::path audit;                    ///< empty: audit.log beside the key
    std::function<void(const std::string&)> say{};  ///< log lines for the technician
  };

  [[nodiscard]] static std::shared_ptr<Access> without_keys();
  /// Error: the key is unreadable, expired or a person's; the revocation list is invalid; or the audit log is unusable.
  [[nodiscard]] static Result<std::shared_ptr<Access>> with_key(Options options);

  [[nodiscard]] bool has_keys() const noexcept { return key_.has_value(); }
  /// TLS for stations and recorders; null without keys.
  [[nodiscard]] const wire::TlsSettings& tls() const noexcept { return tls_; }
  /// TLS for browsers; null without keys.
  [[nodiscard]] const wire::TlsSettings& web_tls() const noexcept { return web_tls_; }
  /// Names and addresses under which clients reach this server, from its key.
  [[nodiscard]] const std::vector<std::string>& hosts() const;

  /// The person behind a peer (not a browser): named by its certificate, else by its `token`. `is_sealed`: the peer
  /// uses TLS. `address`: without the port. Error: no TLS, or neither names a person. Without keys: always `local`.
  [[nodiscard]] Result<keys::Identity> who(bool is_sealed, const std::optional<keys::Identity>& certificate,
                                           std::string_view token, const std::string& address);
  /// The person whom `token` names. After five wrong tokens, `address` must wait (TokenBackOff).
  [[nodiscard]] Result<keys::Identity> bearer(std::string_view token, const std::string& address);

  /// Checks that the role of `who` allows `operation`. Each operation is checked where it enters the server.
  [[nodiscard]] Result<void> may(const keys::Identity& who, keys::Operation operation) const;

  /// False once the key of `who` has expired or is revoked.
  [[nodiscard]] bool still_holds(const keys::Identity& who) const;

  /// Reads the revocation list again if its file changed. Call it each second.
  void look_at_revocations();

  void note(AuditEvent event, const std::string& text);
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
  [[nodiscard]] Result<void> read_revocations();

  std::optional<keys::KeyFile> key_;
  wire::TlsSettings tls_;
  wire::TlsSettings web_tls_;
  std::filesystem::path revoked_file_;
  std::filesystem::file_time_type revoked_read_{};
  std::string unread_said_;  ///< the last error of the revocation list; the same error is not logged again
  keys::Revocations revocations_;
  TokenBackOff back_off_;
  TouchLease touch_;
  std::unique_ptr<AuditLog> audit_;
  std::function<void(const std::string&)> say_;
  Counts counts_;
};

/// "127.0.0.1:4711" -> "127.0.0.1"
[[nodiscard]] std::string host_of(const std::string& peer);

}  // namespace telepalp::access
