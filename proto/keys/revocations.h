#pragma once

#include <map>
#include <string>
#include <string_view>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// The serial numbers of revoked keys and tokens.
class Revocations {
 public:
  /// Reads a revocation list in PEM. `authority`: a certificate in PEM. `file`: the list's name, for errors. Error: the
  /// list is damaged, or not signed with the key of this certificate.
  [[nodiscard]] static Result<Revocations> read(std::string_view pem, std::string_view authority,
                                                const std::string& file);

  [[nodiscard]] bool contains(const std::string& serial) const { return revoked_.contains(serial); }
  /// Time of revocation by serial number.
  [[nodiscard]] const std::map<std::string, WallTime>& all() const noexcept { return revoked_; }

 private:
  std::map<std::string, WallTime> revoked_;
};

}  // namespace telepalp::keys
