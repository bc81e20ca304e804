#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/seal/site_key.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

// An encrypted session file is a header of kSealedHeaderBytes, and the session in blocks of kSealedBlockBytes, each
// encrypted alone with AES-256-GCM, so that a reader can seek. The last block is shorter, or absent. The header, in
// little-endian: "TPSEAL01", the site key's id (16), the file's id (16), the size of a block (4), the file's key,
// encrypted with the site key (113), zeros, the CRC-32 of all before it (4). What is encrypted is bound to its place:
// the key to the file's id, and each block to the file's id and its own number.
inline constexpr std::string_view kSealedMagic = "TPSEAL01";
inline constexpr std::size_t kSealedHeaderBytes = 512;
inline constexpr std::size_t kSealedBlockBytes = std::size_t{64} << 10;
inline constexpr std::size_t kFileIdBytes = 16;

struct SealedHeader {
  std::string site_key_id;
  std::string file_id;
  std::string closed_key;  ///< the file's key, for keys::SiteKey::open()

  /// What the file's key is bound to.
  [[nodiscard]] std::string about_key() const { return std::string(kSealedMagic) + file_id; }
  /// What the block of this number is bound to.
  [[nodiscard]] std::string about_block(std::uint64_t number) const;
};

/// A new header for a file with this key. Error: OpenSSL failed.
[[nodiscard]] Result<SealedHeader> new_header(const keys::SiteKey& site, const keys::FileKey& key);
/// The same file for another site key: only the header changes.
[[nodiscard]] Result<SealedHeader> with_key_of(const SealedHeader& header, const keys::SiteKey& site,
                                               const keys::FileKey& key);

[[nodiscard]] std::string in_bytes(const SealedHeader& header);
/// nullopt: `bytes` are not an encrypted file's header. Error: they were one, and are damaged. `file`: for the error.
[[nodiscard]] Result<std::optional<SealedHeader>> header_in(std::string_view bytes, const std::string& file);

/// The file's key, by the site key of TELEPALP_SITE_KEYS that its header names. Error: it names none of them.
[[nodiscard]] Result<keys::FileKey> file_key_of(const SealedHeader& header, const std::string& file);

}  // namespace telepalp::wire::mcap
