#include "server/oidc/web/web_address.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

namespace telepalp::oidc {
namespace {

constexpr std::size_t kLongest = 1024;
constexpr std::string_view kHttps = "https://";
constexpr std::string_view kHttp = "http://";

bool is_letter_or_digit(char letter) {  // of ASCII, whatever the locale
  return (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
}

bool is_safe_letter(char letter) {
  constexpr std::string_view kPunctuation = "-._~:/?#[]=&%,+;!*()$";
  return is_letter_or_digit(letter) || kPunctuation.find(letter) != std::string_view::npos;
}

bool is_this_machine(std::string_view host) {
  if (host == "localhost") return true;
  boost::system::error_code is_name;
  const auto address = boost::asio::ip::make_address(std::string(host), is_name);
  return !is_name && address.is_loopback();
}

/// "127.0.0.1:8080/login" -> "127.0.0.1", "[::1]:8080" -> "::1"; empty for a bracket that is not closed.
std::string_view host_of(std::string_view rest) {
  rest = rest.substr(0, rest.find_first_of("/?#"));
  const std::size_t closed = rest.find(']');
  if (rest.starts_with('[')) return closed == std::string_view::npos ? std::string_view{} : rest.substr(1, closed - 1);
  return rest.substr(0, rest.find(':'));
}

}  // namespace

bool is_safe_address(std::string_view address) {
  if (address.size() > kLongest || !std::ranges::all_of(address, is_safe_letter)) return false;
  if (address.starts_with(kHttps)) return !host_of(address.substr(kHttps.size())).empty();
  return address.starts_with(kHttp) && is_this_machine(host_of(address.substr(kHttp.size())));
}

bool is_https_origin(std::string_view address) {
  return is_safe_address(address) && address.starts_with(kHttps) &&
         address.find_first_of("/?#", kHttps.size()) == std::string_view::npos && !address.ends_with(":443") &&
         std::ranges::none_of(address, [](char c) { return c >= 'A' && c <= 'Z'; });
}

std::string percent_encoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string encoded;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (is_letter_or_digit(letter) || std::string_view("-._~").find(letter) != std::string_view::npos)
      encoded += letter;
    else
      encoded += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
  }
  return encoded;
}

}  // namespace telepalp::oidc
