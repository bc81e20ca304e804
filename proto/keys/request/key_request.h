#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "proto/keys/key_file.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// Largest size of a file with a request.
inline constexpr std::size_t kMaxRequestBytes = std::size_t{16} * 1024;

/// What an authority reads in a certificate signing request (PKCS#10, RFC 2986). Everything else that a request may ask
/// for, such as hosts, uses and roles, is ignored: the site decides it.
struct KeyRequest {
  std::string name;  ///< the person's, as the request states it: whoever signs must check it
  PublicKey key;
};

/// The text of a request for a certificate of `key`, signed with `key`, so that nobody can ask for a certificate of
/// another one's key. `name`: as for check_name().
[[nodiscard]] Result<std::string> make_request(const std::string& name, EVP_PKEY& key);

/// Reads a request that somebody else made. `file`: its name, for errors. Error: it has more than kMaxRequestBytes; it
/// does not have exactly one request in PEM; the key is not on the curve P-256; the signature is not ECDSA with
/// SHA-256, or was not made with this key; or the name is not exactly one that a key may have.
[[nodiscard]] Result<KeyRequest> read_request(std::string_view text, const std::string& file);

/// The public key of a key file's certificate; null for a token.
[[nodiscard]] PublicKey public_key_of(const KeyFile& key);

/// "SHA256:" and the hash of a public key (SubjectPublicKeyInfo) in hexadecimal, by which two people compare a key.
[[nodiscard]] std::string fingerprint(EVP_PKEY& key);

}  // namespace telepalp::keys
