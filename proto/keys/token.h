#pragma once

#include <string>
#include <string_view>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

using EVP_PKEY = struct evp_pkey_st;

namespace telepalp::keys {

/// Largest length of a token.
inline constexpr std::size_t kMaxTokenBytes = 512;

/// A bearer token: "tp1." payload "." signature, both in URL-safe Base64. The payload is "name role expiry serial"; the
/// authority signs it. So a server needs no list of tokens, and nobody else can make a token.
[[nodiscard]] Result<std::string> sign_token(const Identity& bearer, EVP_PKEY& authority_key);

/// As the function below. `authority_pem`: the authority's certificate in PEM.
[[nodiscard]] Result<Identity> read_token(std::string_view token, std::string_view authority_pem, WallTime now);

/// The person whom `token` names. Error: it is no token, another authority signed it, or it has expired at `now`.
[[nodiscard]] Result<Identity> read_token(std::string_view token, EVP_PKEY& authority_key, WallTime now);

/// 256 random bits in hexadecimal: a new secret.
[[nodiscard]] std::string random_secret();

}  // namespace telepalp::keys
