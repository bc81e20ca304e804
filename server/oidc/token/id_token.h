#pragma once

#include <string>

#include "proto/keys/identity.h"
#include "proto/words/result.h"
#include "server/oidc/token/claims.h"

namespace telepalp::oidc {

inline constexpr std::size_t kMostTokenBytes = 16 * 1024;
inline constexpr std::chrono::seconds kClockError{60};  ///< by which the provider's clock may differ from ours

/// What the token of one log-in must state.
struct Expected {
  std::string issuer;
  std::string client_id;
  std::string nonce;
  keys::WallTime now;
};

/// True if `key_set` (JWKS, RFC 7517) has a key that may have signed `token`. False may mean that the provider has a
/// new key.
[[nodiscard]] bool has_key_of(const std::string& token, const Claims& key_set);

/// The claims of an ID token (OpenID Connect Core 1.0, 3.1.3.7), signed by a key of `key_set` with RS256, PS256 or
/// ES256. Error: the token is cut short, longer than kMostTokenBytes, signed otherwise or not at all, of another issuer
/// or log-in, for another client, expired, or it names nobody.
[[nodiscard]] Result<Claims> check_id_token(const std::string& token, const Claims& key_set, const Expected& expected);

}  // namespace telepalp::oidc
