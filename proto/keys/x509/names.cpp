#include "proto/keys/x509/names.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace telepalp::keys {
namespace {

constexpr std::size_t kMostHosts = 16;

bool is_plain(std::string_view text, std::string_view also) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [&](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           also.find(letter) != std::string_view::npos;
  });
}

bool is_address(std::string_view host) {
  return host.find(':') != std::string_view::npos || host.find_first_not_of("0123456789.") == std::string_view::npos;
}

Error wrong_host(const std::string& host, const std::string& fix) {
  return {.what = "'" + host + "' is not a host name or address", .where = "--host", .fix = fix};
}

Result<void> add_own(std::vector<std::string>& hosts) {
  for (const char* own : {"localhost", "127.0.0.1", "::1"})
    if (std::find(hosts.begin(), hosts.end(), own) == hosts.end()) hosts.emplace_back(own);
  if (hosts.size() <= kMostHosts) return {};
  return Error{.what = "more than 13 hosts are given", .where = "--host", .fix = "give at most 13"};
}

/// The network mask whose first `ones` bits are set: "255.0.0.0" for 8 bits of an IPv4 address.
std::string mask_text(int family, unsigned ones) {
  std::array<unsigned char, 16> bytes{};
  for (unsigned bit = 0; bit < ones; ++bit) bytes[bit / 8] |= static_cast<unsigned char>(0x80U >> (bit % 8));
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(family, bytes.data(), text.data(), text.size());
}

/// "10.0.0.0/8" -> "10.0.0.0/255.0.0.0"; without a prefix, the address alone. nullopt: it is no address, or its prefix
/// is longer than the address.
std::optional<std::string> network(std::string_view host) {
  const std::string address(host.substr(0, host.find('/')));
  const int family = address.find(':') == std::string::npos ? AF_INET : AF_INET6;
  const unsigned most = family == AF_INET ? 32 : 128;
  std::array<unsigned char, 16> bytes{};
  if (inet_pton(family, address.c_str(), bytes.data()) != 1) return std::nullopt;
  unsigned ones = most;
  if (host.size() > address.size()) {
    const std::string_view prefix = host.substr(address.size() + 1);
    const auto [end, failed] = std::from_chars(prefix.data(), prefix.data() + prefix.size(), ones);
    if (failed != std::errc() || end != prefix.data() + prefix.size() || ones == 0 || ones > most) return std::nullopt;
  }
  return address + "/" + mask_text(family, ones);
}

}  // namespace

Result<void> check_name(const std::string& name) {
  if (is_plain(name, "._@-")) return {};
  return Error{.what = "'" + name.substr(0, 80) + "' cannot be the name of a key",
               .where = "--name",
               .fix = "use 1 to 64 letters, digits, dots, hyphens, underscores and @"};
}

Result<std::string> alt_names(std::vector<std::string> hosts) {
  if (const Result<void> few = add_own(hosts); !few) return few.error();
  std::string text;
  for (const std::string& host : hosts) {
    if (!is_plain(host, ".-:"))
      return wrong_host(host, "give the host that clients write after --connect, such as patient.example or 10.0.0.1");
    text += (text.empty() ? "" : ",") + std::string(is_address(host) ? "IP:" : "DNS:") + host;
  }
  return text;
}

Result<std::string> name_limits(std::vector<std::string> hosts) {
  if (const Result<void> few = add_own(hosts); !few) return few.error();
  std::string text = "critical";
  for (const std::string& host : hosts) {
    const std::string fix =
        "give a name such as hospital.example, an address such as 10.0.0.5, or a network such as "
        "10.0.0.0/8";
    if (!is_plain(host, ".-:/")) return wrong_host(host, fix);
    const bool is_network = host.find('/') != std::string::npos || is_address(host);
    const std::optional<std::string> range = is_network ? network(host) : host;
    if (!range || (!is_network && (host.front() == '.' || host.front() == '-'))) return wrong_host(host, fix);
    text += std::string(is_network ? ",permitted;IP:" : ",permitted;DNS:") + *range;
  }
  return text;
}

}  // namespace telepalp::keys
