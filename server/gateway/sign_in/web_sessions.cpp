#include "server/gateway/sign_in/web_sessions.h"

#include <algorithm>

#include "proto/keys/audit_chain.h"
#include "proto/keys/token.h"

namespace telepalp::gateway {

std::string WebSessions::begin(const keys::Identity& who, TimePoint now) {
  if (sessions_.size() >= kMost)
    sessions_.erase(std::min_element(sessions_.begin(), sessions_.end(),
                                     [](const auto& a, const auto& b) { return a.second.begun < b.second.begun; }));
  const std::string cookie = keys::random_secret();
  sessions_[keys::sha256_hex(cookie)] = {.who = who, .begun = now};
  return cookie;
}

std::optional<keys::Identity> WebSessions::find(std::string_view cookie, TimePoint now) const {
  if (cookie.empty()) return std::nullopt;
  const auto found = sessions_.find(keys::sha256_hex(cookie));
  if (found == sessions_.end() || now - found->second.begun > kLongest) return std::nullopt;
  return found->second.who;
}

std::optional<keys::Identity> WebSessions::end(std::string_view cookie) {
  const auto found = sessions_.find(keys::sha256_hex(cookie));
  if (found == sessions_.end()) return std::nullopt;
  const keys::Identity who = found->second.who;
  sessions_.erase(found);
  return who;
}

}  // namespace telepalp::gateway
