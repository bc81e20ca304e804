#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/key_file.h"
#include "proto/keys/revocations.h"
#include "proto/keys/tls_context.h"

namespace telepalp::keys {

/// The newest list of revoked keys that a client has seen. It is kept beside the client's key, in the file KEY.revoked,
/// so that a server can neither leave the list out nor show an older one.
class KnownList {
 public:
  /// Reads KEY.revoked. A missing or damaged one counts as none.
  explicit KnownList(const KeyFile& key);

  /// Takes the list that a server shows, in PEM, and keeps it if it is newer. Error: it is not of the key's authority,
  /// or it is older than the known one.
  [[nodiscard]] Result<void> take(std::string_view pem);

  /// `shown`: take() has succeeded in this session. Error: the key of `server` is revoked; or the server shows no list,
  /// although its certificate promises one, or an earlier server has shown one.
  [[nodiscard]] Result<void> check(const ServerCertificate& server, bool shown) const;

 private:
  std::string authority_;
  std::filesystem::path file_;  // empty: the list is kept in memory alone
  std::optional<Revocations> known_;
};

}  // namespace telepalp::keys
