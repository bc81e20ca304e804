#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "proto/keys/secret/passphrase.h"
#include "proto/words/result.h"

using EVP_PKEY = struct evp_pkey_st;

namespace telepalp::keys {

/// A private or public key of OpenSSL. Shared: copies of a key file use one key, which OpenSSL does not change.
using PrivateKey = std::shared_ptr<EVP_PKEY>;
using PublicKey = std::shared_ptr<EVP_PKEY>;

/// Where a private key is: not in the file; in the file, open to all who may read it; in the file, encrypted with a
/// passphrase; in a hardware token (PKCS#11).
enum class Secret { None, Plain, Encrypted, Token };

/// Beginning of the line that names a private key in a token instead of holding the key (pkcs11.h).
inline constexpr std::string_view kKeyLine = "key: ";

/// How `text` holds a private key.
[[nodiscard]] Secret secret_in(std::string_view text);

/// An open private key.
struct OwnKey {
  PrivateKey key;
  std::string
      text;  ///< what a key file has of it: PEM (PKCS#8), perhaps encrypted, or a line that begins with kKeyLine
};

/// Opens the private key that `text`, the content of `file`, holds or names. `ask` may be empty. Error: there is none,
/// it is damaged, or the passphrase is wrong.
[[nodiscard]] Result<OwnKey> open_private_key(std::string_view text, const std::string& file, const AskPassphrase& ask);

/// A new private key. With a passphrase its text is encrypted (locked()).
[[nodiscard]] Result<OwnKey> make_private_key(const std::string& passphrase);

/// The key in a hardware token at `address` (pkcs11.h).
[[nodiscard]] Result<OwnKey> private_key_in_token(std::string_view address, const AskPassphrase& ask);

/// `key` in PEM, as PKCS#8. With a passphrase it is encrypted: AES-256-CBC, and PBKDF2 with 600 000 rounds of
/// HMAC-SHA-256 (RFC 8018), which `openssl pkey` reads.
[[nodiscard]] Result<std::string> locked(EVP_PKEY& key, const std::string& passphrase);

}  // namespace telepalp::keys
