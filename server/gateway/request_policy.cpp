#include "server/gateway/request_policy.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

namespace telepalp::gateway {
namespace {

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// "127.0.0.1:8080" -> "127.0.0.1", "[::1]:8080" -> "::1"; empty for a bracket that is not closed.
std::string_view without_port(std::string_view host) {
  const std::size_t closed = host.find(']');
  if (host.starts_with('[')) return closed == std::string_view::npos ? std::string_view{} : host.substr(1, closed - 1);
  return host.substr(0, host.find(':'));
}

/// "*.hospital.example" of a web certificate stands for one more label before ".hospital.example" (RFC 6125, 6.4.3).
bool matches_wildcard(const std::vector<std::string>& names, std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot != 0 && dot != std::string_view::npos && contains(names, "*" + std::string(name.substr(dot)));
}

bool is_address(std::string_view host) {
  boost::system::error_code failed;
  boost::asio::ip::make_address(std::string(host), failed);
  return !failed;
}

}  // namespace

bool host_is_ours(const RequestPolicy& policy, std::string_view host) {
  const std::string_view name = without_port(host);
  return name == "localhost" || is_address(name) || contains(policy.allowed_hosts, name) ||
         contains(policy.allowed_hosts, host) || matches_wildcard(policy.allowed_hosts, name);
}

bool origin_is_allowed(const RequestPolicy& policy, std::string_view origin, std::string_view host,
                       bool is_trusted_program) {
  if (origin.empty()) return is_trusted_program;
  if (contains(policy.allowed_origins, origin)) return true;
  return origin == policy.scheme + "://" + std::string(host) && host_is_ours(policy, host);
}

Result<void> check_origin(std::string_view origin) {
  const std::string where = "--allow-origin " + std::string(origin);
  if (origin == "*" || origin == "null")
    return Error{.what = "with this origin, every web page that a user of this server opens could see the patient",
                 .where = where,
                 .fix = "name each origin, such as https://app.foxglove.dev"};
  const std::size_t scheme = origin.find("://");
  const std::string_view host = scheme == std::string_view::npos ? std::string_view{} : origin.substr(scheme + 3);
  const bool is_exact = scheme != 0 && !host.empty() && host.find_first_of("/*?# ,") == std::string_view::npos &&
                        std::none_of(origin.begin(), origin.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  if (is_exact) return {};
  return Error{.what = "this is not the origin of a web page",
               .where = where,
               .fix =
                   "give scheme://host or scheme://host:port in lower case, without a path, such as "
                   "https://app.foxglove.dev or http://localhost:8080"};
}

}  // namespace telepalp::gateway
