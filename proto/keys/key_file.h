#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/identity.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// No key file is larger.
inline constexpr std::size_t kMaxKeyFileBytes = 64 * 1024;

/// The line of a token's file begins so.
inline constexpr std::string_view kTokenLine = "token: ";

/// A file that a person carries: a line for people, and in PEM a certificate with its private key, or a token; and the
/// certificate of the authority, by which the other end is recognised.
struct KeyFile {
  enum class Kind { Server, Client, Token };

  Kind kind = Kind::Client;
  std::string certificate;  ///< PEM; empty for a token
  std::string private_key;  ///< PEM; empty for a token
  std::string authority;    ///< PEM
  std::string authority_name;
  std::string token;               ///< empty for a certificate
  Identity identity;               ///< for a server, the role means nothing
  std::vector<std::string> hosts;  ///< of a server
};

/// Reads the text of a key file, and checks that its parts belong together. `file`: for the error. Expiry is not
/// checked here.
[[nodiscard]] Result<KeyFile> read_key(std::string_view text, const std::string& file);

/// Reads a key file of this machine. Error: anybody may read it, it is no key file, or it has expired at `now`.
[[nodiscard]] Result<KeyFile> load_key(const std::filesystem::path& file, WallTime now);

/// The key that a client's `--key FILE` names; null for an empty name. Error: as above, or it is a server's key.
[[nodiscard]] Result<std::shared_ptr<const KeyFile>> load_client_key(const std::filesystem::path& file, WallTime now);

/// Error: `key` has expired at `now`. `file`: for the error.
[[nodiscard]] Result<void> check_not_expired(const KeyFile& key, WallTime now, const std::string& file);

/// The key in a few lines for people: whose it is, what it allows, until when.
[[nodiscard]] std::string in_words(const KeyFile& key);

/// "2026-11-21 23:10 UTC"
[[nodiscard]] std::string in_words(WallTime time);

}  // namespace telepalp::keys
