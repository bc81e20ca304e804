#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "proto/keys/secret/passphrase.h"
#include "proto/keys/secret/private_key.h"
#include "proto/words/result.h"

namespace telepalp::keys {

/// The key that encrypts the blocks of one file, with AES-256-GCM.
using FileKey = std::array<unsigned char, 32>;
[[nodiscard]] Result<FileKey> new_file_key();
[[nodiscard]] Result<std::string> random_bytes(std::size_t count);

/// Bytes that encryption adds to a block: a random nonce before it, and a tag after it.
inline constexpr std::size_t kSealBytes = 12 + 16;

/// Appends `block`, encrypted, to `into`. `about` is not stored, but must be the same to decrypt. False: OpenSSL
/// failed.
[[nodiscard]] bool seal_block(const FileKey& key, std::string_view about, std::string_view block, std::string& into);
/// Appends the decrypted block to `into`. False: a byte of `sealed` or of `about` was altered; nothing is appended.
[[nodiscard]] bool open_block(const FileKey& key, std::string_view about, std::string_view sealed, std::string& into);

/// The key pair of a site (P-256). Whoever has its public part can encrypt recordings; only the private part decrypts
/// them. So a recorder needs no secret, and a stolen disk shows no patient.
class SiteKey {
 public:
  static constexpr std::size_t kIdBytes = 16;
  static constexpr std::size_t kClosedKeyBytes = 65 + 32 + 16;

  /// Reads `file`: a public part (NAME.pub), or both parts (NAME.key). The private part may be encrypted, or be a line
  /// that names a key in a hardware token; it is opened when it is needed. Error: it is no site key, or others than its
  /// owner may read a private part.
  [[nodiscard]] static Result<SiteKey> load(const std::filesystem::path& file);

  /// The first bytes of the SHA-256 of the public part; in the header of each encrypted file.
  [[nodiscard]] const std::string& id() const noexcept { return id_; }
  [[nodiscard]] bool has_private_part() const noexcept { return secret_ != Secret::None; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

  /// `key`, encrypted for the owner of the private part: kClosedKeyBytes. It works as ECIES: a key pair for this file
  /// alone, ECDH with the site's public part, HKDF-SHA-256 of the shared secret, AES-256-GCM. `about`: as for
  /// seal_block().
  [[nodiscard]] Result<std::string> close(const FileKey& key, std::string_view about) const;
  /// The inverse. Opens the private part first, for which `ask` may be asked. Error: no private part, a wrong
  /// passphrase, or altered bytes.
  [[nodiscard]] Result<FileKey> open(std::string_view closed, std::string_view about, const AskPassphrase& ask) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  std::string id_;
  Secret secret_ = Secret::None;
  PublicKey public_;
  struct Opened {
    std::mutex mutex;
    PrivateKey key;  // guarded by mutex; null until it is needed
  };
  std::shared_ptr<Opened> private_ = std::make_shared<Opened>();  // copies share it, so that nobody is asked twice
};

/// The text of NAME.pub, and the text before the private part in NAME.key.
[[nodiscard]] Result<std::string> public_text(EVP_PKEY& key);

/// `bytes`, such as the number of a key, in hexadecimal digits.
[[nodiscard]] std::string in_hexadecimal_digits(std::string_view bytes);

/// The keys that TELEPALP_SITE_KEYS names, separated by ':'. The first one encrypts new recordings; all that have their
/// private part decrypt. Read again when the variable has changed. Any thread. Empty: the variable is not set. Error: a
/// file that cannot be read.
[[nodiscard]] Result<std::vector<SiteKey>> site_keys_of_environment();

}  // namespace telepalp::keys
