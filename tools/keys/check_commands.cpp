#include <fstream>
#include <map>
#include <optional>

#include "proto/keys/audit_anchor.h"
#include "proto/keys/audit_chain.h"
#include "proto/words/counted.h"
#include "tools/keys/commands.h"
#include "tools/keys/key_folder.h"

namespace telepalp::keys_tool {

Result<std::string> list(const Asked& asked) { return KeyFolder::list(asked.folder); }

Result<std::string> show(const Asked& asked) {
  const Result<std::string> text = keys::read_key_text(asked.file);
  if (!text) return text.error();
  const Result<keys::KeyFile> key = keys::read_public_part(*text, asked.file);
  if (!key) return key.error();
  const bool expired = key->identity.expires <= asked.now;
  return keys::in_words(*key) +
         (expired ? "EXPIRED:    to renew: telepalp-keys renew " + asked.file + " --dir FOLDER-OF-THE-AUTHORITY\n"
                  : "");
}

namespace {

/// The anchors in `file`, by their number of lines. In the file, the certificate of the server that signed an anchor
/// stands before it.
Result<std::map<std::uint64_t, keys::AuditAnchor>> anchors_in(const std::string& file) {
  std::map<std::uint64_t, keys::AuditAnchor> anchors;
  std::ifstream stream(file, std::ios::binary);
  std::string certificate;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t at = line.find("anchor time=");  // a line of the server's log has words before it
    if (at == std::string::npos) {
      if (line.starts_with("-----BEGIN")) certificate.clear();
      certificate += line + "\n";
      continue;
    }
    const Result<keys::AuditAnchor> anchor = keys::read_anchor(std::string_view(line).substr(at), certificate);
    if (!anchor) return anchor.error();
    anchors[anchor->end.lines] = *anchor;
  }
  if (!anchors.empty()) return anchors;
  return Error{.what = "this file has no anchor of an audit log",
               .where = file,
               .fix = "give a copy of LOG.anchors, or the server's certificate and lines 'anchor time=…' of its log"};
}

Error differs_from(const keys::AuditAnchor& anchor, const std::string& log, const char* how) {
  return {.what = std::string("the log ") + how + ": at " + anchor.time + " it had " +
                  std::to_string(anchor.end.lines) + " lines, the last one with the hash " + anchor.end.hash,
          .where = log,
          .fix = "the log was cut or computed anew after that time; look for a copy of it"};
}

}  // namespace

Result<std::string> verify_audit(const Asked& asked) {
  std::map<std::uint64_t, keys::AuditAnchor> anchors;
  if (!asked.anchors.empty()) {
    Result<std::map<std::uint64_t, keys::AuditAnchor>> read = anchors_in(asked.anchors);
    if (!read) return read.error();
    anchors = std::move(read).value();
  }
  std::vector<std::filesystem::path> files = keys::audit_files(asked.file);
  if (files.empty()) files.emplace_back(asked.file);
  keys::AuditVerifier verifier;
  std::optional<keys::AuditAnchor> altered;
  const auto look = [&](std::string_view) {
    const auto anchor = anchors.find(verifier.position().lines);
    if (anchor != anchors.end() && anchor->second.end.hash != verifier.position().hash) altered = anchor->second;
  };
  for (const std::filesystem::path& file : files)
    if (const Result<void> follows = verifier.add_file(file, look); !follows) return follows.error();
  if (altered) return differs_from(*altered, asked.file, "has another line");
  if (!anchors.empty() && anchors.rbegin()->first > verifier.position().lines)
    return differs_from(anchors.rbegin()->second, asked.file, "is shorter");
  const std::uint64_t before = verifier.lines_before();
  return asked.file + (files.size() > 1 ? " and " + counted(files.size() - 1, "older file", "older files") : "") +
         ": " + counted(verifier.position().lines - before, "line", "lines") + ", none altered\n" +
         (before == 0 ? ""
                      : "before them: " + counted(before, "line", "lines") + " in older files, which are not here\n") +
         "last hash:  " + verifier.position().hash + "\n" +
         (anchors.empty()
              ? "To check that no lines were removed at the end, give the server's anchors, kept elsewhere: "
                "--anchors FILE\n"
              : counted(anchors.size(), "anchor", "anchors") + " of the server match\n");
}

}  // namespace telepalp::keys_tool
