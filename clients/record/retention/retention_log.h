#pragma once

#include <filesystem>
#include <string>

#include "proto/keys/audit_chain.h"
#include "proto/words/result.h"

namespace telepalp::record {

/// The audit log of deletions: hash-chained lines (proto/keys/audit_chain.h), each on the disk before note() returns.
/// `telepalp-keys audit-verify` checks it. A lock on the file keeps other processes from writing it.
class RetentionLog {
 public:
  /// Opens `file`, or makes it, and checks its chain. Error: it was altered, another process has its lock, or it cannot
  /// be written.
  [[nodiscard]] static Result<RetentionLog> open(const std::filesystem::path& file);
  RetentionLog(RetentionLog&& other) noexcept;
  RetentionLog& operator=(RetentionLog&&) = delete;
  ~RetentionLog();

  /// Appends the line "time=… event=EVENT" and waits until the disk has it. Error: it could not be written; the log is
  /// as before.
  [[nodiscard]] Result<void> note(const std::string& event);

  [[nodiscard]] const keys::AuditPosition& position() const noexcept { return position_; }

 private:
  RetentionLog(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

  std::filesystem::path file_;
  int descriptor_;
  keys::AuditPosition position_;
};

}  // namespace telepalp::record
