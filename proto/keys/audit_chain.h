#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::keys {

/// An audit log is lines of "hash text", where hash = SHA-256(hash of the line before, newline, text) in hexadecimal.
/// AuditVerifier detects each altered, removed or inserted byte, except removed last lines and recomputed hashes (the
/// hash has no key). A copy of the last hash, kept elsewhere, reveals these two, too.
struct AuditPosition {
  std::uint64_t lines = 0;
  std::string hash = std::string(64, '0');  ///< hash of the last line
};

/// The next line of the log, with its newline. Advances `position` to this line. Escapes control characters in `text`.
[[nodiscard]] std::string audit_line(AuditPosition& position, std::string_view text);

/// Checks a log line by line, from the first line, in constant memory.
class AuditVerifier {
 public:
  /// Error: this line does not match its hash; the error states its number. The position then stays.
  [[nodiscard]] Result<void> add(std::string_view line);  ///< without its newline
  [[nodiscard]] const AuditPosition& position() const noexcept { return position_; }

 private:
  AuditPosition position_;
};

[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace telepalp::keys
