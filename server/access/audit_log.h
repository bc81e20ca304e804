#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "proto/keys/audit_chain.h"
#include "proto/keys/identity.h"
#include "proto/words/result.h"

namespace telepalp::access {

/// The events that the log records. name() gives the word in the log.
enum class AuditEvent {
  Started,
  Stopped,
  Joined,
  Left,
  Records,
  TookTouch,
  OfferedTouch,
  GaveTouch,
  Rearmed,
  Refused,
  SignedIn,
  SignedOut,
  OpenedSession,
  BroughtSession,
  ChoseSource,
  SetExposure
};
[[nodiscard]] std::string_view name(AuditEvent event) noexcept;

/// A file of hash-chained lines (proto/keys/audit_chain.h), one for each event: "time=… event=joined who=doctor anna
/// from=10.0.0.7:4711 …". Each line is passed to the operating system before the next event is handled. Owner: the
/// server's network thread.
class AuditLog {
 public:
  /// Opens `file` and continues its chain. A file whose chain is broken is renamed to FILE.damaged-N, and `say` gets a
  /// message. Error: the broken file cannot be renamed, `file` cannot be written, or it is no regular file.
  [[nodiscard]] static Result<std::unique_ptr<AuditLog>> open(const std::filesystem::path& file,
                                                              const std::function<void(const std::string&)>& say);

  /// Writes one line. It never fails, because a full disk must not stop the patient's stream: the next line that can be
  /// written states how many lines are missing, and `say` gets one message. In 10 s at most 20 refusals of strangers
  /// (peers that no key or token names) and 200 refusals of named peers are written, so that nobody can fill the disk;
  /// the next line states how many refusals were left out.
  void note(AuditEvent event, const std::string& text, keys::WallTime now);

  [[nodiscard]] std::uint64_t lines() const noexcept { return position_.lines; }
  [[nodiscard]] std::uint64_t not_written() const noexcept { return not_written_; }

 private:
  AuditLog(std::filesystem::path file, keys::AuditPosition position, std::function<void(const std::string&)> say);
  [[nodiscard]] bool append(const std::string& line);
  [[nodiscard]] bool is_too_often(AuditEvent event, const std::string& text, keys::WallTime now);

  std::filesystem::path file_;
  std::ofstream stream_;
  keys::AuditPosition position_;
  std::function<void(const std::string&)> say_;
  std::uint64_t not_written_ = 0;
  std::uint64_t missing_said_ = 0;  // part of not_written_ that a later line has reported
  keys::WallTime refusals_since_{};
  std::uint64_t strangers_ = 0;  // number of refused strangers in the present 10 s
  std::uint64_t others_ = 0;     // number of refused named peers in the present 10 s
  std::uint64_t unsaid_ = 0;     // refusals left out since the last line
};

}  // namespace telepalp::access
