#pragma once

#include <string>
#include <string_view>

namespace telepalp::oidc {

/// True if `address` begins with https://, or with http:// and a host of this machine, and has only letters, digits and
/// punctuation that need no escape in HTML, in a header or in a command of HTTP.
[[nodiscard]] bool is_safe_address(std::string_view address);

/// True if `address` is the origin of a page as browsers write it: https, in lower case, without the port 443, without
/// path, query and fragment: "https://tele.hospital.example:8443".
[[nodiscard]] bool is_https_origin(std::string_view address);

/// `text` in a query or a posted form: all but letters, digits and -._~ as %XX (RFC 3986, 2.1).
[[nodiscard]] std::string percent_encoded(std::string_view text);

}  // namespace telepalp::oidc
