#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/key_file.h"
#include "proto/keys/secret/private_key.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// The validity of a certificate begins this long before its creation, because the clocks of two machines differ.
inline constexpr std::chrono::hours kBackdated{1};

/// Issues the keys of one site, and revokes them. The authority's file never leaves the machine on which keys are made.
/// Each of server_key(), client_key() and token() returns the text of a key file (key_file.h).
class Authority {
 public:
  struct Issue {
    std::string name;  ///< letters, digits and ". _ @ -"; 1 to 64 of them
    Role role = Role::Viewer;
    WallTime now{};
    std::chrono::days valid{365};
    /// The holder's public key, of a request that was read (key_request.h); the text then has no private key. Null: the
    /// key pair is made here.
    PublicKey key{};
    OwnKey own{};  ///< the private key, if it exists already; null: a new one
  };
  /// `hosts`: the only names, addresses and networks for which it may sign, as for name_limits(); empty: all, as
  /// authorities of older versions. `own`: its private key; null: a new one without a passphrase.
  [[nodiscard]] static Result<Authority> create(const std::string& name, WallTime now, std::chrono::days valid,
                                                const std::vector<std::string>& hosts = {}, OwnKey own = {});
  [[nodiscard]] static Result<Authority> read(std::string_view file_text, const std::string& file,
                                              const AskPassphrase& ask = {});
  /// The same authority with the same key, so that all that it signed stays valid; with a new certificate.
  [[nodiscard]] Result<Authority> renewed(WallTime now, std::chrono::days valid,
                                          const std::vector<std::string>& hosts) const;
  Authority(Authority&&) noexcept;
  Authority& operator=(Authority&&) noexcept;
  ~Authority();

  [[nodiscard]] std::string file_text() const;    ///< text of the authority's file, with its private key
  [[nodiscard]] std::string certificate() const;  ///< PEM, for browsers and other programs; it is not secret
  [[nodiscard]] std::string name() const;
  /// The names, addresses and networks for which it may sign; empty: for all.
  [[nodiscard]] std::vector<std::string> hosts() const;
  /// True if this authority's key signed `key`.
  [[nodiscard]] bool has_signed(const KeyFile& key) const;

  /// `hosts`: the names and addresses under which clients reach the server; localhost, 127.0.0.1 and ::1 are added.
  /// Error: this authority may not sign for one of them.
  [[nodiscard]] Result<std::string> server_key(const Issue& issue, const std::vector<std::string>& hosts) const;
  [[nodiscard]] Result<std::string> client_key(const Issue& issue) const;
  [[nodiscard]] Result<std::string> token(const Issue& issue) const;

  /// The signed list, in PEM, of `revoked`: the time of revocation by serial number. `number`: higher than that of each
  /// earlier list. Revocations::read() reads it.
  [[nodiscard]] Result<std::string> revocation_list(const std::map<std::string, WallTime>& revoked, WallTime now,
                                                    std::uint64_t number = 1) const;

 private:
  struct Parts;
  explicit Authority(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::keys
