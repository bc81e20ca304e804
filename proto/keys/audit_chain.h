#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

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

/// The fields by which the first line of a log's second or later file continues the chain: "lines=20411 after=HASH".
/// `end`: the position at which the previous file ended.
[[nodiscard]] std::string audit_continuation(const AuditPosition& end);

/// The value of the field `event` in the first line of a file that continues another one.
inline constexpr std::string_view kAuditContinues = "continues";

/// Checks a log line by line, in constant memory. It begins at the log's first line, or at the first line of a later
/// file: then it takes the position of the previous file's end from that line's audit_continuation().
class AuditVerifier {
 public:
  /// Error: this line does not match its hash; the error states its number. The position then stays.
  [[nodiscard]] Result<void> add(std::string_view line);  ///< without its newline
  /// Checks all lines of a file. Error: the file cannot be read, one of its lines was altered, or its last line has no
  /// newline. `look` gets each line without its hash.
  [[nodiscard]] Result<void> add_file(const std::filesystem::path& file,
                                      const std::function<void(std::string_view text)>& look = {});
  [[nodiscard]] const AuditPosition& position() const noexcept { return position_; }
  /// Number of the log's lines before the first checked line.
  [[nodiscard]] std::uint64_t lines_before() const noexcept { return lines_before_; }

 private:
  AuditPosition position_;
  std::uint64_t lines_before_ = 0;
};

/// The files of the log `log` that exist, in the order of their lines: LOG.1, LOG.2, …, LOG.
[[nodiscard]] std::vector<std::filesystem::path> audit_files(const std::filesystem::path& log);

/// The name to which the file `log` is renamed when it is full: LOG.4 if the newest such file is LOG.3.
[[nodiscard]] std::filesystem::path next_audit_file(const std::filesystem::path& log);

[[nodiscard]] std::array<unsigned char, 32> sha256(std::string_view bytes);
[[nodiscard]] std::string sha256_hex(std::string_view bytes);  ///< in hexadecimal

}  // namespace telepalp::keys
