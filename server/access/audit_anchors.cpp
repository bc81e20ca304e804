#include "server/access/audit_anchors.h"

#include <sys/stat.h>

#include <fstream>
#include <utility>

#include "proto/words/numbers/utc_text.h"

namespace telepalp::access {

AuditAnchors::AuditAnchors(const std::filesystem::path& log, const keys::KeyFile& server, Say say)
    : file_(log.string() + ".anchors"), server_(server), say_(std::move(say)) {
  std::ifstream stream(file_, std::ios::binary);
  for (std::string line; std::getline(stream, line);)
    if (const auto anchor = keys::read_anchor(line, server.certificate)) at_start_ = *anchor;
}

void AuditAnchors::look(const keys::AuditPosition& end, keys::WallTime now, bool always) {
  constexpr std::chrono::hours kEvery{1};
  if (end.lines == lines_ || (!always && now - signed_ < kEvery && now >= signed_)) return;
  const Result<std::string> line = keys::anchor_line({.time = utc_stamp(now), .end = end}, server_);
  if (!line) return say_("the audit log is not anchored: " + to_string(line.error()));
  signed_ = now;
  lines_ = end.lines;
  newest_ = *line;
  say_("audit log: " + newest_);
  append((std::exchange(has_certificate_, true) ? "" : server_.certificate) + newest_ + "\n");
}

/// Does not report a full disk: the anchor is in the server's log too, and a copy beside the audit log protects
/// nothing.
void AuditAnchors::append(const std::string& text) {
  const mode_t mask = ::umask(0077);
  std::ofstream(file_, std::ios::app | std::ios::binary) << text;
  ::umask(mask);
}

}  // namespace telepalp::access
