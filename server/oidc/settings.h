#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/keys/role.h"
#include "proto/words/result.h"

namespace telepalp::oidc {

/// A person whose claim `claim` is `value`, or a list with it, gets `role`.
struct Rule {
  std::string claim;
  std::string value;
  keys::Role role = keys::Role::Viewer;
};

/// What a file *.sign_in.textproto states (proto/messages/sign_in.proto), checked.
struct Settings {
  std::string issuer;
  std::string client_id;
  std::string client_secret;               ///< empty: the client has none (a public client)
  std::filesystem::path authority_file{};  ///< empty: the system's authorities
  std::string page;                        ///< "https://tele.hospital.example:8443", without a path
  std::string scope = "openid profile";
  std::string name_claim = "preferred_username";
  std::chrono::seconds longest = std::chrono::hours(8);  ///< from signing in until signing in again
  std::vector<Rule> rules;

  /// Where the provider sends the browser back to. The hospital registers it at the provider.
  [[nodiscard]] std::string back() const;
};

/// Path of Settings::back() at this server.
inline constexpr const char* kBackTarget = "/sign-in/back";

/// Error: with file, line and column, a value is missing or wrong; or the file of the secret or of the authority cannot
/// be read, or others than its owner have access to the secret.
[[nodiscard]] Result<Settings> read_settings(const std::filesystem::path& file);

}  // namespace telepalp::oidc
