#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// The validity of a certificate begins this long before its creation, because the clocks of two machines differ.
inline constexpr std::chrono::hours kBackdated{1};

/// Issues the keys of one site, and revokes them. The authority's file never leaves the machine on which keys are made.
/// Each of server_key(), client_key() and token() returns the text of a key file (key_file.h).
class Authority {
 public:
  struct Issue {
    std::string name;  ///< letters, digits and ". _ @ -"; 1 to 64 of them
    Role role = Role::Viewer;
    WallTime now{};
    std::chrono::days valid{365};
  };
  [[nodiscard]] static Result<Authority> create(const std::string& name, WallTime now, std::chrono::days valid);
  [[nodiscard]] static Result<Authority> read(std::string_view file_text, const std::string& file);
  Authority(Authority&&) noexcept;
  Authority& operator=(Authority&&) noexcept;
  ~Authority();

  [[nodiscard]] std::string file_text() const;    ///< text of the authority's file, with its private key
  [[nodiscard]] std::string certificate() const;  ///< PEM, for browsers and other programs; it is not secret
  [[nodiscard]] std::string name() const;

  /// `hosts`: the names and addresses under which clients reach the server; localhost, 127.0.0.1 and ::1 are added.
  [[nodiscard]] Result<std::string> server_key(const Issue& issue, const std::vector<std::string>& hosts) const;
  [[nodiscard]] Result<std::string> client_key(const Issue& issue) const;
  [[nodiscard]] Result<std::string> token(const Issue& issue) const;

  /// The signed list, in PEM, of `revoked`: the time of revocation by serial number. `number`: higher than that of each
  /// earlier list. Revocations::read() reads it.
  [[nodiscard]] Result<std::string> revocation_list(const std::map<std::string, WallTime>& revoked, WallTime now,
                                                    std::uint64_t number = 1) const;

 private:
  struct Parts;
  explicit Authority(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace telepalp::keys
