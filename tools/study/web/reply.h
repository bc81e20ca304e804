#pragma once

#include <boost/beast/http.hpp>

#include "tools/study/web/door.h"
#include "tools/study/web/page_files.h"

namespace telepalp::study {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpReply = boost::beast::http::response<boost::beast::http::string_body>;

/// The address of the WebSocket.
inline constexpr std::string_view kLiveTarget = "/live";

/// Answers a request for a file of the page. Pure.
[[nodiscard]] HttpReply reply_to(const HttpRequest& request, const PageFiles& files, const Door& door);

/// Why the WebSocket is refused; nullopt: it may be opened. Pure.
[[nodiscard]] std::optional<HttpReply> refusal_of_live(const HttpRequest& request, const Door& door);

}  // namespace telepalp::study
