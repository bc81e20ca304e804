#pragma once

#include <string_view>

namespace telepalp::server {

/// Whether an Accept-Encoding header takes gzip: it names gzip or, when it does not, "*", with a weight above 0
/// (RFC 9110, 12.5.3).
[[nodiscard]] bool takes_gzip(std::string_view accept_encoding) noexcept;

/// Whether an If-None-Match header names `etag`; "W/" before a tag changes nothing here, "*" names every tag
/// (RFC 9110, 13.1.2). Our tags hold no comma.
[[nodiscard]] bool names_etag(std::string_view if_none_match, std::string_view etag) noexcept;

}  // namespace telepalp::server
