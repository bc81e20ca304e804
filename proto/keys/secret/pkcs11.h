#pragma once

#include <string>
#include <string_view>

#include "proto/keys/secret/passphrase.h"
#include "proto/keys/secret/private_key.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// True for the address of a key in a hardware token or a smart card (RFC 7512), which begins with "pkcs11:".
[[nodiscard]] bool is_pkcs11(std::string_view text) noexcept;

/// The parts of such an address that telepalp reads by itself.
struct Pkcs11Address {
  std::string key;     ///< the address without its query: what OpenSSL's engine looks for
  std::string object;  ///< the key's label
  std::string module;  ///< the token's driver, from `module-path`; empty: the engine's own choice
};
/// Error: it is longer than 512 characters, has characters that an address cannot have, names no object, or has a PIN:
/// other users of the machine see a command line.
[[nodiscard]] Result<Pkcs11Address> read_pkcs11(std::string_view text);

/// The private key at `address`, which never leaves the token. Loads OpenSSL's engine `pkcs11` and the token's driver.
/// `ask` is asked once for the PIN, because a token locks itself after a few wrong ones.
[[nodiscard]] Result<PrivateKey> open_pkcs11(const Pkcs11Address& address, const AskPassphrase& ask);

}  // namespace telepalp::keys
