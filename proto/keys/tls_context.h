#pragma once

#include <openssl/ssl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/key_file.h"
#include "proto/words/result.h"

namespace telepalp::keys {

struct FreeTlsContext {
  void operator()(SSL_CTX* context) const noexcept { SSL_CTX_free(context); }
};
using TlsContextPtr = std::unique_ptr<SSL_CTX, FreeTlsContext>;
/// True if the certificate of `who` is revoked, and so refused.
using IsRevoked = std::function<bool(const Identity& who)>;

/// TLS 1.3 without certificate and without trust in anybody. Session resumption is off, so that each session checks the
/// certificate again.
[[nodiscard]] Result<TlsContextPtr> bare_context(const SSL_METHOD* method);

/// TLS 1.3 for a server with `key`. A client's certificate is checked if the client sends one, also by `is_revoked`, at
/// each handshake. Session resumption is off, so that each session checks the certificate again.
[[nodiscard]] Result<TlsContextPtr> server_context(const KeyFile& key, IsRevoked is_revoked);

/// TLS 1.3 for a server that serves browsers, which are not asked for a certificate.
[[nodiscard]] Result<TlsContextPtr> web_server_context(const KeyFile& key);

/// TLS 1.3 for a client: trusts only the authority of the client's key, and shows the key's certificate if it has one.
[[nodiscard]] Result<TlsContextPtr> client_context(const KeyFile& key);

/// Lets the client's `session` accept only a server whose certificate names `host`, a name or an address, and sends
/// `host` in the ClientHello (RFC 6066 §3). A `host` that cannot be checked, such as an empty one, refuses every
/// server.
void expect_host(SSL& session, const std::string& host);

/// The person whom the peer's verified certificate names; nullopt: the peer sent none, or one without a role.
[[nodiscard]] std::optional<Identity> identity_of_peer(SSL& session);

/// What a server's certificate says: its hosts and its serial number.
struct HostCertificate {
  std::vector<std::string> hosts;
  std::string serial;
};
/// The verified certificate that the peer has shown; empty: it has shown none.
[[nodiscard]] HostCertificate host_certificate_of_peer(SSL& session);

/// What a client must know of a server's verified certificate.
struct ServerCertificate {
  std::string serial;
  bool promises_list = false;  ///< the server shows each client the list of revoked keys
};
/// nullopt: the peer sent no certificate, or it was not verified.
[[nodiscard]] std::optional<ServerCertificate> certificate_of_server(SSL& session);

/// 32 bytes that only both ends of a session know (RFC 8446, 7.5), per `label`; nullopt before the handshake ends.
[[nodiscard]] std::optional<std::array<std::byte, 32>> keying_material(SSL& session, std::string_view label);

/// Explains why a client's handshake or read failed, if every further attempt to connect would fail, too; nullopt:
/// another attempt may succeed. `code`: OpenSSL's error code. `host`: as for expect_host().
[[nodiscard]] std::optional<Error> refusal_of(SSL& session, unsigned long code, const KeyFile& key,
                                              const std::string& host);

}  // namespace telepalp::keys
