#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/secret/passphrase.h"
#include "proto/keys/secret/private_key.h"
#include "proto/keys/tls_context.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// A certificate that browsers trust already, such as a hospital's ordinary one, with its private key. The web port
/// shows it in place of the server's own.
struct WebCertificate {
  std::string chain;  ///< PEM: the server's certificate first, then those between it and the authority
  PrivateKey private_key;
  std::vector<std::string> hosts;  ///< may begin with "*."
  WallTime expires{};
};

/// Reads the chain in `certificate` and the private key in `key`, both in PEM. Error: one cannot be read or is larger
/// than kMaxKeyFileBytes; they do not belong together; the first certificate is expired at `now`, is not for servers or
/// names no host; the passphrase is wrong; or users other than its owner have access to the private key.
[[nodiscard]] Result<WebCertificate> load_web_certificate(const std::filesystem::path& certificate,
                                                          const std::filesystem::path& key, WallTime now,
                                                          const AskPassphrase& ask = ask_passphrase);

/// TLS 1.3 for a server that shows `certificate` to browsers, which are not asked for one.
[[nodiscard]] Result<TlsContextPtr> web_server_context(const WebCertificate& certificate);

}  // namespace telepalp::keys
