#include "support/program/address.h"

#include <charconv>

namespace telepalp::program {

Result<Address> parse_address(std::string_view text, std::string_view where) {
  const auto wrong = [&] {
    return Error{.what = "'" + std::string(text) + "' is not HOST:PORT",
                 .where = std::string(where),
                 .fix = "write it as 127.0.0.1:7400 or [::1]:7400"};
  };
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return wrong();
  std::string_view host = text.substr(0, colon);
  if (host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  else if (host.find(':') != std::string_view::npos)
    return wrong();
  const std::string_view digits = text.substr(colon + 1);
  std::uint16_t port = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (code != std::errc{} || end != digits.data() + digits.size() || port == 0 || host.empty()) return wrong();
  return Address{std::string(host), port};
}

}  // namespace telepalp::program
