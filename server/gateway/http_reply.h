#pragma once

#include <boost/beast/http.hpp>
#include <string_view>

#include "proto/words/time.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/static_files.h"

namespace telepalp::gateway {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpReply = boost::beast::http::response<boost::beast::http::string_body>;

/// Boost's string view as the standard library's.
[[nodiscard]] inline std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

/// Path of the session clock, served as decimal nanoseconds. The viewer estimates the offset between the browser's
/// clock and the session clock from the round trip of this request, to show the age of the displayed data.
inline constexpr std::string_view kClockTarget = "/session_clock";

/// Answers a request that is not a WebSocket upgrade. `now`: the current session time. Pure.
[[nodiscard]] HttpReply reply_to(const HttpRequest& request, const StaticFiles& files, const RequestPolicy& policy,
                                 SessionTime now);

/// An error reply with one line of text as its body.
[[nodiscard]] HttpReply refuse(const HttpRequest& request, boost::beast::http::status status, std::string_view reason);

}  // namespace telepalp::gateway
