#pragma once

#include <nats/nats.h>

#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::nats {

/// What libnats adds to the text of `status`, without the place in its own source, "(conn.c:2088): ", which means
/// nothing to a user.
inline std::string detail_of(natsStatus status) {
  const char* const last = nats_GetLastError(nullptr);
  std::string_view text = last == nullptr ? "" : last;
  if (const std::size_t end = text.find("): "); text.starts_with("(") && end != text.npos) text.remove_prefix(end + 3);
  return text.empty() || text == natsStatus_GetText(status) ? "" : ": " + std::string(text);
}

inline Error refused(natsStatus status, const std::string& where, const std::string& fix) {
  return {.what = natsStatus_GetText(status) + detail_of(status), .where = where, .fix = fix};
}

}  // namespace telepalp::nats
