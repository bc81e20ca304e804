#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/audit_anchor.h"
#include "proto/keys/audit_chain.h"
#include "proto/keys/identity.h"
#include "proto/words/result.h"
#include "server/access/file_lock.h"
#include "server/access/line_budget.h"

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
  AcceptedObject,
  Refused,
  SignedIn,
  SignedOut,
  OpenedSession,
  BroughtSession,
  ChoseSource,
  SetExposure,
  SetMicrophone,
  SentOut,
  LetIn,
  TookAwayTouch,
  Damaged
};
[[nodiscard]] std::string_view name(AuditEvent event) noexcept;

/// A file of hash-chained lines (proto/keys/audit_chain.h), one for each event: "time=… event=joined who=doctor anna
/// from=10.0.0.7:4711 …". Each line is passed to the operating system before the next event is handled. When the file
/// FILE has grown to `most_bytes`, it is renamed to FILE.1 (FILE.2, …), and the next FILE continues its chain; no file
/// is ever deleted. The field `time` never decreases: when the machine's clock was set back, the field `clock` has its
/// time. Owner: the server's network thread.
class AuditLog {
 public:
  using Say = std::function<void(const std::string&)>;
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

  /// Opens `file` and continues its chain. `anchored`: a position that the log has had (AuditAnchors); nullopt:
  /// unknown. When the log has it no longer, alarm() gives a text. A file whose chain is broken is renamed to
  /// FILE.damaged-N; the new FILE continues at the last line before the damage and says so in its first lines; alarm()
  /// then gives a text. Error: another server writes `file`, the broken file cannot be renamed, `file` cannot be
  /// written, or it is no regular file.
  [[nodiscard]] static Result<std::unique_ptr<AuditLog>> open(const std::filesystem::path& file, const Say& say,
                                                              std::uintmax_t most_bytes = kMostBytes,
                                                              const std::optional<keys::AuditAnchor>& anchored = {});

  /// Writes one line about the peer whose key has the number `serial`; empty: a stranger, whom no key or token names;
  /// nullopt: the server itself. It never fails, because a full disk must not stop the patient's stream: the next line
  /// that can be written states how many lines are missing, and `say` gets one message. Beyond a peer's budget
  /// (LineBudget) its lines are left out, but not those with which a stream begins or ends; the next line states how
  /// many were left out.
  void note(AuditEvent event, const std::optional<std::string>& serial, const std::string& text, keys::WallTime now);

  /// True if the peer's budget of lines (LineBudget) allows another stream. The log keeps a line for each stream, so a
  /// peer that has used up its budget gets no stream.
  [[nodiscard]] bool may_join(const std::string& serial, keys::WallTime now);

  /// Why the log cannot be trusted; empty: it can. The alarm stays while a file FILE.damaged-N is beside the log.
  [[nodiscard]] std::string alarm() const;

  [[nodiscard]] const keys::AuditPosition& position() const noexcept { return position_; }
  [[nodiscard]] std::uint64_t lines() const noexcept { return position_.lines; }
  [[nodiscard]] std::uint64_t not_written() const noexcept { return not_written_; }

 private:
  AuditLog(std::filesystem::path file, std::uintmax_t most_bytes, Say say)
      : file_(std::move(file)), most_bytes_(most_bytes), say_(std::move(say)) {}
  [[nodiscard]] Result<void> read_end(const std::optional<keys::AuditAnchor>& anchored);
  [[nodiscard]] Result<void> put_aside(const std::filesystem::path& broken, const Error& why);
  [[nodiscard]] Result<void> is_cut(const keys::AuditAnchor& anchored);
  [[nodiscard]] bool open_file();
  void begin_file(keys::WallTime now);
  void begin_next_file();
  [[nodiscard]] bool append(const std::string& line);
  [[nodiscard]] bool write(const std::string& text, keys::WallTime now);
  [[nodiscard]] bool is_too_often(AuditEvent event, const std::optional<std::string>& serial, keys::WallTime now);

  std::filesystem::path file_;
  std::uintmax_t most_bytes_;
  Say say_;
  FileLock lock_;
  std::ofstream stream_;
  keys::AuditPosition position_;
  std::string last_time_;          // the field `time` of the last line
  std::filesystem::path damaged_;  // a file FILE.damaged-N beside the log; empty: there is none
  std::string cut_;                // why the log is not the one that was anchored; empty: it is
  std::string continues_;  // for the first line of a new file: the name of the file before it; empty: it is written
  LineBudget budget_;
  std::uint64_t not_written_ = 0;
  std::uint64_t missing_said_ = 0;  // part of not_written_ that a later line has reported
  std::uint64_t left_out_ = 0;      // lines beyond a budget since the last line
  bool rename_failed_ = false;
};

}  // namespace telepalp::access
