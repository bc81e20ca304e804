#include "proto/keys/audit_chain.h"

#include <openssl/sha.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHashDigits = 2 * SHA256_DIGEST_LENGTH;

/// Removes `prefix` from the start of `text`; false: it does not start with it.
bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// The position at which the previous file ended, if `text` is a line that continues it: "time=… event=continues
/// lines=7 after=HASH"; else nullopt. A peer's text comes later in a line, so that it cannot imitate these fields.
std::optional<AuditPosition> continued_from(std::string_view text) {
  AuditPosition end;
  if (!skip(text, "time=")) return std::nullopt;
  text.remove_prefix(std::min(text.find(' '), text.size()));
  if (!skip(text, " event=" + std::string(kAuditContinues) + " lines=")) return std::nullopt;
  const auto [after, wrong] = std::from_chars(text.data(), text.data() + text.size(), end.lines);
  text.remove_prefix(static_cast<std::size_t>(after - text.data()));
  if (wrong != std::errc() || !skip(text, " after=") || text.size() < kHashDigits) return std::nullopt;
  end.hash = text.substr(0, kHashDigits);
  return end;
}

/// The number at the end of "audit.log.12", of the log "audit.log"; nullopt: it is no file of this log.
std::optional<std::uint64_t> number_of(std::string_view name, std::string_view log) {
  if (!skip(name, log) || !skip(name, ".")) return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, wrong] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (wrong != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return number;
}

std::map<std::uint64_t, fs::path> numbered_files(const fs::path& log) {
  std::map<std::uint64_t, fs::path> files;
  std::error_code failed;
  const fs::path folder = log.has_parent_path() ? log.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (const auto number = number_of(entry.path().filename().string(), log.filename().string()))
      files.emplace(*number, entry.path());
  return files;
}

std::string hash_of(const std::string& before, std::string_view text) {
  return sha256_hex(before + "\n" + std::string(text));
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(letter));
    const bool control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
    safe += control ? std::string(code) : std::string(1, letter);
  }
  return safe;
}

}  // namespace

std::array<unsigned char, SHA256_DIGEST_LENGTH> sha256(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(bytes_of(bytes), bytes.size(), digest.data());
  return digest;
}

std::string sha256_hex(std::string_view bytes) { return in_hexadecimal(sha256(bytes)); }

std::string audit_line(AuditPosition& position, std::string_view text) {
  const std::string safe = escaped(text);
  position.hash = hash_of(position.hash, safe);
  ++position.lines;
  return position.hash + " " + safe + "\n";
}

std::string audit_continuation(const AuditPosition& end) {
  return "lines=" + std::to_string(end.lines) + " after=" + end.hash;
}

Result<void> AuditVerifier::add(std::string_view line) {
  const bool shaped = line.size() > kHashDigits && line[kHashDigits] == ' ';
  const std::string_view text = shaped ? line.substr(kHashDigits + 1) : std::string_view{};
  AuditPosition before = position_;
  if (position_.lines == 0) before = continued_from(text).value_or(before);
  const std::string number = std::to_string(before.lines + 1);
  const std::string hash = shaped ? hash_of(before.hash, text) : std::string();
  if (!shaped || line.substr(0, kHashDigits) != hash)
    return Error{.what = "the hash of line " + number +
                         " does not match: this line was altered, or lines directly before it were removed",
                 .where = "line " + number,
                 .fix = "compare the audit log with a copy from an earlier day; the hashes of all lines before line " +
                        number + " match"};
  if (position_.lines == 0) lines_before_ = before.lines;
  position_ = {.lines = before.lines + 1, .hash = hash};
  return {};
}

Result<void> AuditVerifier::add_file(const fs::path& file, const std::function<void(std::string_view)>& look) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return Error{
        .what = "the log cannot be read", .where = file.string(), .fix = "check its name, and that you may read it"};
  for (std::string line; std::getline(stream, line);) {
    const Result<void> follows =
        stream.eof()
            ? Error{.what =
                        "the last line is cut off: the server was ended while it wrote this line, or bytes were "
                        "removed",
                    .where = "line " + std::to_string(position_.lines + 1),
                    .fix = "compare the log with an earlier copy; the hashes of the lines before this line match"}
            : add(line);
    if (!follows)
      return Error{.what = follows.error().what,
                   .where = file.string() + ", " + follows.error().where,
                   .fix = follows.error().fix};
    if (look) look(std::string_view(line).substr(kHashDigits + 1));
  }
  return {};
}

std::vector<fs::path> audit_files(const fs::path& log) {
  std::vector<fs::path> files;
  for (const auto& [number, file] : numbered_files(log)) files.push_back(file);
  std::error_code failed;
  if (fs::exists(log, failed)) files.push_back(log);
  return files;
}

fs::path next_audit_file(const fs::path& log) {
  const std::map<std::uint64_t, fs::path> files = numbered_files(log);
  return log.string() + "." + std::to_string(files.empty() ? 1 : files.rbegin()->first + 1);
}

}  // namespace telepalp::keys
