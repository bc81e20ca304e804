#pragma once

#include <boost/beast/http.hpp>

#include "proto/words/time.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/static_files.h"

namespace telepalp::server {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpReply = boost::beast::http::response<boost::beast::http::string_body>;

/// What a browser asks beside files: the session clock, as decimal nanoseconds, so that a viewer can tell how old
/// what it shows is. It measures its own clock's offset by the time that this takes.
inline constexpr std::string_view kClockTarget = "/session_clock";

/// Answers a request that is no WebSocket upgrade. Pure: `now` is what the session clock reads.
[[nodiscard]] HttpReply reply_to(const HttpRequest& request, const StaticFiles& files, const RequestPolicy& policy,
                                 SessionTime now);

/// A refusal with a line of text for whoever reads it.
[[nodiscard]] HttpReply refuse(const HttpRequest& request, boost::beast::http::status status, std::string_view reason);

}  // namespace telepalp::server
