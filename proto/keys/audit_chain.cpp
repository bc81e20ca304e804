#include "proto/keys/audit_chain.h"

#include <openssl/sha.h>

#include <array>
#include <cstdio>

namespace telepalp::keys {
namespace {

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

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  std::string text;
  for (const unsigned char byte : digest) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    text += digits;
  }
  return text;
}

std::string audit_line(AuditPosition& position, std::string_view text) {
  const std::string safe = escaped(text);
  position.hash = hash_of(position.hash, safe);
  ++position.lines;
  return position.hash + " " + safe + "\n";
}

Result<void> AuditVerifier::add(std::string_view line) {
  const std::string number = std::to_string(position_.lines + 1);
  const std::size_t hash_digits = position_.hash.size();
  const bool shaped = line.size() > hash_digits && line[hash_digits] == ' ';
  const std::string hash = shaped ? hash_of(position_.hash, line.substr(hash_digits + 1)) : std::string();
  if (!shaped || line.substr(0, hash_digits) != hash)
    return Error{.what = "the hash of line " + number +
                         " does not match: this line was altered, or lines directly before it were removed",
                 .where = "line " + number,
                 .fix = "compare the audit log with a copy from an earlier day; the hashes of all lines before line " +
                        number + " match"};
  position_ = {.lines = position_.lines + 1, .hash = hash};
  return {};
}

}  // namespace telepalp::keys
