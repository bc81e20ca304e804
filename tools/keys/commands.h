#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/keys/secret/private_key.h"
#include "proto/words/result.h"

namespace telepalp::keys_tool {

/// The values of telepalp-keys' command line. Each function below runs one command and returns its text for stdout.
struct Asked {
  std::filesystem::path folder;
  std::string file;  ///< the file that the command names, or for revoke a serial number; empty: none
  std::string name;
  std::string role;
  std::vector<std::string> hosts;
  std::string anchors;      ///< a file with copied anchors of the audit log; empty: none
  std::string key;          ///< the address of a private key in a hardware token; empty: a new key is made in a file
  bool passphrase = false;  ///< protects the new private key with a passphrase
  std::optional<std::chrono::days> valid;
  keys::WallTime now{};
};

/// What a key or token for a person needs on the command line: --role and --name.
[[nodiscard]] Result<void> check_person(const Asked& asked);
/// What a server's key and an authority need on the command line: --host.
[[nodiscard]] Result<void> check_hosts(const Asked& asked);
/// What a request needs on the command line: --name.
[[nodiscard]] Result<void> check_name_given(const Asked& asked);
/// What a signature needs on the command line: --role for a person, or --host for a server.
[[nodiscard]] Result<void> check_person_or_hosts(const Asked& asked);

[[nodiscard]] Result<std::string> make_authority(const Asked& asked);
[[nodiscard]] Result<std::string> make_server_key(const Asked& asked);
[[nodiscard]] Result<std::string> make_client_key(const Asked& asked);
[[nodiscard]] Result<std::string> make_token(const Asked& asked);
[[nodiscard]] Result<std::string> sign(const Asked& asked);
[[nodiscard]] Result<std::string> renew(const Asked& asked);
[[nodiscard]] Result<std::string> revoke(const Asked& asked);

[[nodiscard]] Result<std::string> make_key_and_request(const Asked& asked);
/// The key pair of a site, for its encrypted recordings: NAME-site.key and NAME-site.pub.
[[nodiscard]] Result<std::string> make_site_key(const Asked& asked);
[[nodiscard]] Result<std::string> set_passphrase(const Asked& asked);
/// The private key that a command uses: the one in the token of --key, else a new one, if wanted with a passphrase.
/// `what`: whose it is, for the question.
[[nodiscard]] Result<keys::OwnKey> own_key(const Asked& asked, const std::string& what);

[[nodiscard]] Result<std::string> list(const Asked& asked);
[[nodiscard]] Result<std::string> show(const Asked& asked);
[[nodiscard]] Result<std::string> verify_audit(const Asked& asked);

}  // namespace telepalp::keys_tool
