#include "support/program/address.h"

#include <charconv>

#include "support/program/default_ports.h"

namespace telepalp::program {

Result<Address> parse_address(std::string_view text, std::string_view where, std::string_view default_port) {
  const Error wrong{
      .what = "'" + std::string(text) + "' is not " + (default_port.empty() ? "HOST:PORT" : "HOST or HOST:PORT"),
      .where = std::string(where),
      .fix = "write the address as 127.0.0.1:7400 or [::1]:7400, with a port from 1 to 65535"};
  // The last colon is before the port, but for an address in brackets that ends the text.
  const std::size_t colon = text.ends_with(']') ? std::string_view::npos : text.rfind(':');
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = colon == std::string_view::npos ? default_port : text.substr(colon + 1);
  if (host.starts_with('[') && host.ends_with(']'))
    host = host.substr(1, host.size() - 2);
  else if (host.find_first_of(":[]") != std::string_view::npos)
    return wrong;
  std::uint16_t port = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (code != std::errc{} || end != digits.data() + digits.size() || port == 0 || host.empty()) return wrong;
  return Address{std::string(host), port};
}

Result<Address> parse_server(std::string_view text, std::string_view where) {
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) return parse_address(text, where, kServerPort);
  Result<Address> meet = parse_address(text.substr(at + 1), where, kMeetPort);
  if (!meet) return meet;
  const std::string_view site = text.substr(0, at);
  constexpr std::string_view kOfNames = "abcdefghijklmnopqrstuvwxyz0123456789-.";
  if (site.empty() || site.size() > 253 || site.find_first_not_of(kOfNames) != std::string_view::npos)
    return Error{
        .what = "'" + std::string(site) + "' is not the name of a site",
        .where = std::string(where),
        .fix =
            "write SITE@HOST with the name that the site's server shows when it joins the meeting point: small "
            "letters, digits, hyphens and dots"};
  meet->site = site;
  return meet;
}

std::string to_text(const Address& address) {
  const bool is_v6 = address.host.find(':') != std::string::npos;
  return (address.site.empty() ? "" : address.site + "@") + (is_v6 ? "[" + address.host + "]" : address.host) + ":" +
         std::to_string(address.port);
}

}  // namespace telepalp::program
