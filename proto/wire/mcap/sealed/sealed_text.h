#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/seal/site_key.h"
#include "proto/wire/mcap/sealed/sealed_header.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

// The encrypted form of a small file beside a session, such as its notes: an encrypted session's header, and the text
// as one block whose number no session has. So a text cannot be mistaken for a session's blocks, and a text of which a
// part is missing is not read in part.

/// Bytes that encryption adds to a text.
inline constexpr std::size_t kSealedTextExtra_B = kSealedHeaderBytes + keys::kSealBytes;

/// `text`, encrypted for `site`, of which the public part is enough. Error: OpenSSL failed.
[[nodiscard]] Result<std::string> sealed_text(const keys::SiteKey& site, std::string_view text);

/// The text of a file with these bytes, encrypted or not. Error: TELEPALP_SITE_KEYS does not name the private part of
/// its key, or a byte of an encrypted file was altered or is missing. `file`: for the error.
[[nodiscard]] Result<std::string> text_of(std::string bytes, const std::string& file);

/// The header of `file`, a session or a text on the disk; nullopt: it is not encrypted. Error: it cannot be opened, or
/// its header is damaged.
[[nodiscard]] Result<std::optional<SealedHeader>> header_of(const std::filesystem::path& file);

/// `text` as a file beside `session` has it: encrypted for the same site key if the session is encrypted, so that
/// whoever reads the session reads the text. Where no session is yet, as for a new one. Error: TELEPALP_SITE_KEYS does
/// not name the session's key.
[[nodiscard]] Result<std::string> text_beside(const std::filesystem::path& session, std::string_view text);

}  // namespace telepalp::wire::mcap
