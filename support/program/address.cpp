#include "support/program/address.h"

#include <charconv>

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

std::string to_text(const Address& address) {
  const bool is_v6 = address.host.find(':') != std::string::npos;
  return (is_v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

}  // namespace telepalp::program
