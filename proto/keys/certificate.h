#pragma once

#include <span>
#include <string>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {

/// The fields of a new certificate.
struct CertificateRequest {
  std::string name;       ///< common name
  std::string alt_names;  ///< subjectAltName as in OpenSSL's configuration: "DNS:host,IP:10.0.0.1"; empty: none
  std::string usage;      ///< extendedKeyUsage: "serverAuth", "clientAuth"; empty: the certificate of an authority
  std::string limits{};   ///< of an authority: nameConstraints, as name_limits() writes them; empty: none
  std::string serial;     ///< in hexadecimal
  WallTime from{};
  WallTime until{};
};

/// A certificate for `key`, signed by `issuer` with `issuer_key`. `issuer` null: the certificate is self-signed, and
/// `issuer_key` must be `key`.
[[nodiscard]] Result<CertificatePtr> make_certificate(const CertificateRequest& request, EVP_PKEY& key, X509* issuer,
                                                      EVP_PKEY& issuer_key);

/// The person whom a client's certificate, verified by the caller, names. Error: the certificate states no known role.
[[nodiscard]] Result<Identity> identity_of(X509& certificate);

[[nodiscard]] std::string common_name(X509& certificate);
[[nodiscard]] std::vector<std::string> host_names(X509& certificate);  ///< DNS names and addresses
[[nodiscard]] bool is_authority(X509& certificate);
/// The hosts for which an authority may sign (nameConstraints), such as "hospital.example" and "10.0.0.0/8"; empty: for
/// all.
[[nodiscard]] std::vector<std::string> permitted_hosts(X509& authority);
/// True if OpenSSL accepts `certificate` below `authority`, whatever the date: names and uses are within its limits.
[[nodiscard]] bool is_permitted(X509& certificate, X509& authority);
[[nodiscard]] bool promises_list(X509& certificate);  ///< kListUri is among its alternative names

/// The URI in subjectAltName that carries a role: kRoleUri + "doctor".
inline constexpr std::string_view kRoleUri = "telepalp:role:";

/// The URI in subjectAltName of a server that shows each client the list of revoked keys. A client refuses such a
/// server when it shows none: whoever took the server's key cannot leave the list out. (As "must staple", RFC 7633.)
inline constexpr std::string_view kListUri = "telepalp:shows-revocations";

}  // namespace telepalp::keys
