#include <fstream>

#include "proto/keys/audit_chain.h"
#include "proto/words/counted.h"
#include "tools/keys/commands.h"
#include "tools/keys/key_folder.h"

namespace telepalp::keys_tool {

Result<std::string> list(const Asked& asked) {
  const Result<KeyFolder> folder = KeyFolder::open(asked.folder);
  if (!folder) return folder.error();
  return folder->list();
}

Result<std::string> show(const Asked& asked) {
  const Result<std::string> text = read_file(asked.file, keys::kMaxKeyFileBytes);
  if (!text) return text.error();
  const Result<keys::KeyFile> key = keys::read_key(*text, asked.file);
  if (!key) return key.error();
  const bool expired = key->identity.expires <= asked.now;
  return keys::in_words(*key) +
         (expired ? "EXPIRED:    to renew: telepalp-keys renew " + asked.file + " --dir FOLDER-OF-THE-AUTHORITY\n"
                  : "");
}

Result<std::string> verify_audit(const Asked& asked) {
  std::ifstream log(asked.file, std::ios::binary);
  if (!log)
    return Error{
        .what = "the log cannot be read", .where = asked.file, .fix = "check its name, and that you may read it"};
  keys::AuditVerifier verifier;
  for (std::string line; std::getline(log, line);) {
    const Result<void> follows =
        log.eof() ? Error{.what =
                              "the last line is cut off: the server was ended while it wrote this line, or bytes were "
                              "removed",
                          .where = "line " + std::to_string(verifier.position().lines + 1),
                          .fix = "compare the log with an earlier copy; the hashes of the lines before this line match"}
                  : verifier.add(line);
    if (!follows)
      return Error{
          .what = follows.error().what, .where = asked.file + ", " + follows.error().where, .fix = follows.error().fix};
  }
  return asked.file + ": " + counted(verifier.position().lines, "line", "lines") +
         ", none altered\nlast hash:  " + verifier.position().hash +
         "\nTo check that no lines were removed at the end, search the file for a last hash that you noted earlier.\n";
}

}  // namespace telepalp::keys_tool
