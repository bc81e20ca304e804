#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::oidc {

/// One request to the provider. With a form it is a POST, else a GET.
struct WebRequest {
  std::string address;  ///< is_safe_address()
  std::string form{};   ///< URL-encoded
  std::string user{};   ///< with `password`, for HTTP Basic; empty: none
  std::string password{};
  std::string bearer{};  ///< access token; empty: none
};

struct WebReply {
  long status = 0;
  std::string body;  ///< at most kMostReplyBytes
};

inline constexpr std::size_t kMostReplyBytes = 64 * 1024;

/// Sends `request` and waits for the reply, at most five seconds. Follows no redirect. TLS is checked against the
/// authority in `authority_file`, or against the system's. Ends early once `stopped` is true. Error: no reply came, or
/// it is larger than kMostReplyBytes.
[[nodiscard]] Result<WebReply> fetch(const WebRequest& request, const std::filesystem::path& authority_file,
                                     const std::atomic<bool>& stopped);

}  // namespace telepalp::oidc
