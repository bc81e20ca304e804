#pragma once

#include <string>
#include <string_view>

namespace telepalp::keys {

/// A text of a person or of a peer, as the value of one field of an audit log: its first 200 bytes in double quotes,
/// with each double quote inside replaced by an apostrophe. So a peer's name cannot imitate another field.
[[nodiscard]] inline std::string audit_text(std::string_view text) {
  std::string safe(text.substr(0, 200));
  for (char& letter : safe)
    if (letter == '"') letter = '\'';
  return "\"" + safe + "\"";
}

}  // namespace telepalp::keys
