#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::server {

/// Who may talk to the gateway, judged from a request's headers alone.
struct RequestPolicy {
  /// Names beside IP addresses and "localhost" under which this server is reached, as "host" or "host:port".
  std::vector<std::string> allowed_hosts;
  /// Origins beside the server's own whose pages may open the stream: "https://viewer.example".
  std::vector<std::string> allowed_origins;
};

/// Whether `origin` is one that a browser sends: scheme://host or scheme://host:port, in lower case. "*" and "null" are
/// errors: any web page, or any file, could then read the patient.
[[nodiscard]] Result<void> check_origin(std::string_view origin);

/// True for an IP address or "localhost", with or without a port, and for what the policy names. Any other name may
/// be a foreign page's own name that was made to resolve to this machine (DNS rebinding).
[[nodiscard]] bool host_is_ours(const RequestPolicy& policy, std::string_view host);

/// True when a page from `origin` may open a WebSocket: the page that `host` itself served, or one that is allowed.
/// No origin at all comes from no browser; such a tool is let in from this machine only.
[[nodiscard]] bool origin_is_allowed(const RequestPolicy& policy, std::string_view origin, std::string_view host,
                                     bool peer_is_loopback);

}  // namespace telepalp::server
