#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "proto/keys/audit_anchor.h"

namespace telepalp::access {

/// Signs the position of the audit log with the server's key: at the server's start and end, and each hour in which the
/// log has grown. The lines go to the log of the server, to the technician's page, and to the file LOG.anchors, after
/// the server's certificate. Whoever copies them to another machine can tell later whether the log was cut, or
/// its hashes were computed again. Owner: the server's network thread.
class AuditAnchors {
 public:
  using Say = std::function<void(const std::string&)>;

  /// `log`: the audit log. `server`: its key must outlive this object.
  AuditAnchors(const std::filesystem::path& log, const keys::KeyFile& server, Say say);

  /// The newest anchor that the file LOG.anchors had at the start and that this server's key signed; nullopt: none.
  [[nodiscard]] const std::optional<keys::AuditAnchor>& at_start() const noexcept { return at_start_; }
  /// The newest anchor's line; empty: none yet.
  [[nodiscard]] const std::string& newest() const noexcept { return newest_; }

  /// Signs `end` if an hour has passed since the last anchor and the log has grown. `always`: also earlier.
  void look(const keys::AuditPosition& end, keys::WallTime now, bool always = false);

 private:
  void append(const std::string& text);

  std::filesystem::path file_;
  const keys::KeyFile& server_;
  Say say_;
  std::optional<keys::AuditAnchor> at_start_;
  std::string newest_;
  std::uint64_t lines_ = 0;  // number of lines at the newest anchor
  keys::WallTime signed_{};
  bool has_certificate_ = false;  // this run has written the server's certificate to the file
};

}  // namespace telepalp::access
