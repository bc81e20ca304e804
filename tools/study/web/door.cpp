#include "tools/study/web/door.h"

#include <sys/random.h>

#include <array>
#include <boost/asio/ip/address.hpp>

#include "proto/words/demand.h"

namespace telepalp::study {
namespace {

constexpr std::string_view kTokenWord = "?token=";

/// As in an URL: an IPv6 address in brackets.
std::string bracketed(const std::string& address) {
  return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

/// "any address of this machine" is no address to open.
std::string openable(const std::string& listen) {
  boost::system::error_code failed;
  const auto address = boost::asio::ip::make_address(listen, failed);
  if (failed || !address.is_unspecified()) return listen;
  return address.is_v6() ? "::1" : "127.0.0.1";
}

bool is_address(std::string_view name) {
  if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
  boost::system::error_code failed;
  boost::asio::ip::make_address(std::string(name), failed);
  return !failed;
}

}  // namespace

std::string new_token() {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::array<unsigned char, kTokenLetters / 2> bytes{};
  demand(getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
         "the system gives random bytes");
  std::string token;
  for (const unsigned char byte : bytes) token += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  return token;
}

Result<Door> new_door(const std::string& listen, std::int64_t port) {
  boost::system::error_code failed;
  boost::asio::ip::make_address(listen, failed);
  if (failed) return Error{.what = "'" + listen + "' is no IP address", .where = "--listen", .fix = "give 127.0.0.1"};
  return Door{.listen = listen, .port = static_cast<std::uint16_t>(port), .token = new_token()};
}

std::string page_address(const Door& door) {
  return "http://" + bracketed(openable(door.listen)) + ":" + std::to_string(door.port) + "/" +
         std::string(kTokenWord) + door.token;
}

bool host_is_ours(const Door& door, std::string_view host) {
  const std::string port = ":" + std::to_string(door.port);
  if (!host.ends_with(port)) return false;
  const std::string_view name = host.substr(0, host.size() - port.size());
  return name == "localhost" || is_address(name);
}

bool origin_is_ours(const Door& door, std::string_view origin, std::string_view host) {
  return origin.empty() || (host_is_ours(door, host) && origin == "http://" + std::string(host));
}

bool has_token(const Door& door, std::string_view target) {
  const std::size_t at = target.find(kTokenWord);
  if (at == std::string_view::npos) return false;
  const std::string_view given = target.substr(at + kTokenWord.size());
  if (given.size() != door.token.size() || given.empty()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    different |= static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(door.token[i]);
  return different == 0;
}

}  // namespace telepalp::study
