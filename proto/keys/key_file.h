#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/secret/passphrase.h"
#include "proto/keys/secret/private_key.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// Largest size of a key file.
inline constexpr std::size_t kMaxKeyFileBytes = std::size_t{64} * 1024;

/// Beginning of the line that holds the token in a token's file.
inline constexpr std::string_view kTokenLine = "token: ";

/// The content of a key file, which a person or a server holds. The file begins with a line that describes it to
/// people. Then come either a certificate and its private key (PEM), or a token; and last the certificate of the
/// authority, which is needed to check the peer's certificate. The private key may be encrypted, or be a line that
/// names a key in a hardware token. A person who made the key pair alone (`telepalp-keys request`) has two files:
/// NAME.key with the private key, and NAME.crt with both certificates.
struct KeyFile {
  enum class Kind { Server, Client, Token };

  Kind kind = Kind::Client;
  Secret secret = Secret::None;
  std::string certificate;   ///< PEM; empty for a token
  PrivateKey private_key{};  ///< null for a token, and where only the public part was read
  std::string authority;     ///< PEM
  std::string authority_name;
  std::string token;               ///< empty for a certificate
  Identity identity;               ///< whom the certificate or token names; for a server's key, the role is meaningless
  std::vector<std::string> hosts;  ///< host names of a server's key; empty for others
  std::filesystem::path path{};    ///< where load_key() read it; empty: it was not read from a file
};

/// Reads the text of a key file. `file`: its name, for errors. `ask`: for the passphrase of an encrypted key; empty:
/// such a key is refused. Error: it is no key file, its parts do not belong together, or the passphrase is wrong. Does
/// not check the expiry.
[[nodiscard]] Result<KeyFile> read_key(std::string_view text, const std::string& file, const AskPassphrase& ask = {});

/// As read_key(), but reads only what is not secret, so that no passphrase is needed. The text may lack the private
/// key.
[[nodiscard]] Result<KeyFile> read_public_part(std::string_view text, const std::string& file);

/// The content of the key file `file`, without a check; for a private key whose certificate is in NAME.crt beside it,
/// both files, one after the other. Error: it cannot be read, or has more than kMaxKeyFileBytes.
[[nodiscard]] Result<std::string> read_key_text(const std::filesystem::path& file);

/// From now on no core dump of this process is written, and no other process of this user reads its memory (ptrace).
/// Both would contain the key.
void forbid_dumps() noexcept;

/// Reads a key file from the disk, after forbid_dumps(). `file` may be the address of a key in a hardware token,
/// "pkcs11:…;object=LABEL": the certificates are then in LABEL.crt in the working folder, as if LABEL.key were there.
/// Error: it cannot be read, is no key file, has expired at `now`, users other than its owner have access to it, or the
/// passphrase is wrong. The group of a file that root owns may read it.
[[nodiscard]] Result<KeyFile> load_key(const std::filesystem::path& file, WallTime now,
                                       const AskPassphrase& ask = ask_passphrase);

/// As load_key(), but nobody is asked in the terminal: if the environment has no passphrase for an encrypted key or a
/// hardware token, the key is returned without its private key.
[[nodiscard]] Result<KeyFile> load_key_unasked(const std::filesystem::path& file, WallTime now);

/// The key that a client's `--key FILE` names; null for an empty name. Error: as for load_key(), or the file is a
/// server's key.
[[nodiscard]] Result<std::shared_ptr<const KeyFile>> load_client_key(const std::filesystem::path& file, WallTime now,
                                                                     const AskPassphrase& ask = ask_passphrase);

/// Replaces `file` as a whole, readable by its owner alone, without waiting for the disk. False: it cannot be written.
bool replace_file(const std::filesystem::path& file, std::string_view text);

/// Error: `key` has expired at `now`. `file`: its name, for the error.
[[nodiscard]] Result<void> check_not_expired(const KeyFile& key, WallTime now, const std::string& file);

/// Error: users other than the owner of `file` have access to it. The group of a file that root owns may read it: so an
/// administrator gives a key to a service that cannot change it.
[[nodiscard]] Result<void> check_private(const std::filesystem::path& file);

/// Describes the key in a few lines: whose it is, what it allows, until when, and what protects it.
[[nodiscard]] std::string in_words(const KeyFile& key);

/// "2026-11-21 23:10 UTC"
[[nodiscard]] std::string in_words(WallTime time);

}  // namespace telepalp::keys
