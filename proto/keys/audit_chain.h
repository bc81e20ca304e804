#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::keys {

/// An audit log is lines of "hash text", where hash = SHA-256(hash of the line before, newline, text) in hexadecimal. A
/// verifier detects each altered, removed or inserted byte, except the removal of the last lines. It detects this
/// removal, too, by comparison with a copy of the last hash that is kept elsewhere.
struct AuditPosition {
  std::uint64_t lines = 0;
  std::string hash = std::string(64, '0');  ///< hash of the last line
};

/// The next line of the log, with its newline; advances `position` to it. Control characters in `text` are escaped.
[[nodiscard]] std::string audit_line(AuditPosition& position, std::string_view text);

/// Checks a log piece by piece, in constant memory.
class AuditVerifier {
 public:
  /// Error: the number of the first line that is wrong.
  [[nodiscard]] Result<void> add(std::string_view line);  ///< without its newline
  [[nodiscard]] const AuditPosition& position() const noexcept { return position_; }

 private:
  AuditPosition position_;
};

[[nodiscard]] std::string sha256_hex(std::string_view bytes);

}  // namespace telepalp::keys
