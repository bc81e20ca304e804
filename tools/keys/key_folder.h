#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "proto/keys/authority.h"
#include "proto/keys/key_file.h"
#include "proto/keys/revocations.h"

namespace telepalp::keys_tool {

/// The folder in which a site's keys are made: authority.key (secret), authority.crt (public), issued.txt (one line
/// for each issued key or token), revoked.crl (the revocation list, for the server), and the keys and tokens.
class KeyFolder {
 public:
  /// Error: the folder already has an authority.
  [[nodiscard]] static Result<void> check_has_none(const std::filesystem::path& folder);
  /// Creates the folder with a new authority. Error: as for check_has_none().
  [[nodiscard]] static Result<KeyFolder> create(const std::filesystem::path& folder, keys::Authority authority,
                                                keys::WallTime now);
  /// Reads the authority's key, and asks for its passphrase if it has one.
  [[nodiscard]] static Result<KeyFolder> open(const std::filesystem::path& folder);

  [[nodiscard]] const keys::Authority& authority() const noexcept { return authority_; }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  /// Writes a new key to `file` and notes it in issued.txt. Error: `file` exists and `replace` is false.
  [[nodiscard]] Result<void> keep(const std::string& key_text, const std::filesystem::path& file, bool replace) const;

  /// Adds `serial`, and all other certificates of the same key pair, to revoked.crl, which gets the next number;
  /// returns the number of serials in revoked.crl.
  [[nodiscard]] Result<std::size_t> revoke(const std::string& serial, keys::WallTime now) const;

  /// The text of issued.txt, with "REVOKED" after each revoked entry. Needs no private key.
  [[nodiscard]] static Result<std::string> list(const std::filesystem::path& folder);

  /// Error: a certificate of the key pair with this fingerprint was revoked, so whoever stole the private key could use
  /// a new certificate. `file`: for the error.
  [[nodiscard]] Result<void> check_not_revoked(const std::string& fingerprint, const std::string& file) const;

  /// Writes `renewed`, the same authority with a new certificate, to authority.crt and authority.key.
  [[nodiscard]] Result<void> replace_authority(const keys::Authority& renewed) const;

 private:
  KeyFolder(std::filesystem::path folder, keys::Authority authority)
      : folder_(std::move(folder)), authority_(std::move(authority)) {}
  [[nodiscard]] Result<keys::Revocations> revoked() const;
  [[nodiscard]] Result<void> write_revoked(const std::map<std::string, keys::WallTime>& all, std::uint64_t number,
                                           keys::WallTime now) const;

  std::filesystem::path folder_;
  keys::Authority authority_;
};

/// The content of `file`. Error: the file cannot be read, or is larger than `most` bytes.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file, std::size_t most);

}  // namespace telepalp::keys_tool
