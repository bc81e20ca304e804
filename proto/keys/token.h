#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

using EVP_PKEY = struct evp_pkey_st;

namespace telepalp::keys {

/// Largest length of a token.
inline constexpr std::size_t kMaxTokenBytes = 512;

/// Label of the TLS exporter's bytes that a program signs with its token's secret (RFC 8446, 7.5).
inline constexpr std::string_view kTokenKeyLabel = "EXPORTER-telepalp-token";

/// A token: "tp2." payload "." signature "." secret, each in URL-safe Base64. The payload is "name role expiry serial
/// public-key"; the authority signs it. So a server needs no list of tokens, and nobody else can make a token. The
/// secret belongs to the public key (Ed25519). A program keeps it: it sends the token without its secret, and a proof
/// that holds for one TLS session alone. Tokens of older versions ("tp1.", without public key and secret) are bearer
/// tokens.
[[nodiscard]] Result<std::string> sign_token(const Identity& bearer, EVP_PKEY& authority_key);

/// A token without its secret, and the proof that the sender has the secret: its signature of `exporter`, 32 bytes that
/// only both ends of this TLS session know.
struct ProvedToken {
  std::string token;
  std::string proof;
};
/// The form in which a program sends `token`. A token without a secret is left as it is, with an empty proof.
[[nodiscard]] ProvedToken prove_token(std::string_view token, std::span<const std::byte> exporter);

/// The proof of a token that came over a TLS session; both empty: there is none.
struct TokenProof {
  std::string_view signature;
  std::span<const std::byte> exporter;
};

/// As the function below. `authority_pem`: the authority's certificate in PEM.
[[nodiscard]] Result<Identity> read_token(std::string_view token, std::string_view authority_pem, WallTime now,
                                          const TokenProof& proof = {});

/// The person whom `token` names. Error: it is no token, another authority signed it, it has expired at `now`, or it
/// has neither its secret nor a valid proof of it.
[[nodiscard]] Result<Identity> read_token(std::string_view token, EVP_PKEY& authority_key, WallTime now,
                                          const TokenProof& proof = {});

/// 256 random bits in hexadecimal: a new secret.
[[nodiscard]] std::string random_secret();

}  // namespace telepalp::keys
