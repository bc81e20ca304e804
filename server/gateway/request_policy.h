#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::gateway {

/// Access rules of the gateway, applied to a request's headers.
struct RequestPolicy {
  /// Host names of this server, as "host", "host:port" or "*.domain". IP addresses and "localhost" are always allowed.
  std::vector<std::string> allowed_hosts;
  /// Scheme of the server's own pages: "https" with keys.
  std::string scheme = "http";
  /// Further origins whose pages may open the WebSocket, for example "https://viewer.example". The server's own
  /// origin is always allowed.
  std::vector<std::string> allowed_origins;
};

/// The answer to a request whose Host header is not a name of this server.
inline constexpr std::string_view kNotOurHost =
    "this server does not know the name by which it was addressed (Host header): use its IP address, or a host that "
    "its key names";

/// Checks that `origin` has the form that a browser sends: scheme://host or scheme://host:port, in lower case. "*" and
/// "null" are errors: they would let any web page, or any local file, read the patient's data.
[[nodiscard]] Result<void> check_origin(std::string_view origin);

/// True for an IP address, "localhost" and the policy's host names, with or without a port. Another name may belong to
/// a foreign web page whose DNS name was made to resolve to this machine (DNS rebinding).
[[nodiscard]] bool host_is_ours(const RequestPolicy& policy, std::string_view host);

/// True when a page from `origin` may open a WebSocket: `origin` is the policy's scheme and `host`, which is a name of
/// this server, or the policy allows `origin`. A request without an origin does not come from a browser's page; it is
/// accepted only if `is_trusted_program`: the request comes from this machine, or has a valid token.
[[nodiscard]] bool origin_is_allowed(const RequestPolicy& policy, std::string_view origin, std::string_view host,
                                     bool is_trusted_program);

}  // namespace telepalp::gateway
