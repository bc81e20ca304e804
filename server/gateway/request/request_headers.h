#pragma once

#include <string_view>

namespace telepalp::gateway {

/// True when an Accept-Encoding header allows `coding`, "gzip" or "br": the header lists `coding`, or else "*", with a
/// weight above 0 (RFC 9110, 12.5.3).
[[nodiscard]] bool takes_coding(std::string_view accept_encoding, std::string_view coding) noexcept;

/// True when an If-None-Match header lists `etag` or "*". A prefix "W/" of a tag is ignored (RFC 9110, 13.1.2). `etag`
/// contains no comma.
[[nodiscard]] bool names_etag(std::string_view if_none_match, std::string_view etag) noexcept;

}  // namespace telepalp::gateway
