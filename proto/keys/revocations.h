#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// The serial numbers of revoked keys and tokens, as an authority signed them. Each list of an authority has a higher
/// number than the one before.
class Revocations {
 public:
  /// Reads a revocation list in PEM. `authority`: a certificate in PEM. `file`: the list's name, for errors. Error: the
  /// list is damaged, or not signed with the key of this certificate.
  [[nodiscard]] static Result<Revocations> read(std::string_view pem, std::string_view authority,
                                                const std::string& file);

  /// The number of the list (RFC 5280, 5.2.3); 0: one of an older telepalp-keys, which wrote none.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
  [[nodiscard]] bool contains(const std::string& serial) const { return revoked_.contains(serial); }
  /// Time of revocation by serial number.
  [[nodiscard]] const std::map<std::string, WallTime>& all() const noexcept { return revoked_; }

 private:
  std::map<std::string, WallTime> revoked_;
  std::uint64_t number_ = 0;
};

}  // namespace telepalp::keys
