#include "server/gateway/request/request_headers.h"

#include <algorithm>
#include <optional>

namespace telepalp::gateway {
namespace {

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The text before the first `separator`; `rest` keeps what follows it.
std::string_view take_until(char separator, std::string_view& rest) noexcept {
  const std::size_t at = rest.find(separator);
  const std::string_view taken = rest.substr(0, at);
  rest = at == std::string_view::npos ? std::string_view{} : rest.substr(at + 1);
  return trimmed(taken);
}

/// Whether `text` is `name`, which is in lower case, in any case.
bool is_named(std::string_view text, std::string_view name) noexcept {
  const auto alike = [](char a, char b) { return (a | 0x20) == b; };
  return text.size() == name.size() && std::equal(text.begin(), text.end(), name.begin(), alike);
}

/// False for "q=0", "q=0.0" and so on.
bool has_weight(std::string_view parameters) noexcept {
  while (!parameters.empty()) {
    const std::string_view one = take_until(';', parameters);
    if (one.starts_with("q=") || one.starts_with("Q=")) return one.find_first_of("123456789") != std::string_view::npos;
  }
  return true;
}

}  // namespace

bool takes_coding(std::string_view accept_encoding, std::string_view coding) noexcept {
  bool any = false;
  while (!accept_encoding.empty()) {
    std::string_view parameters = take_until(',', accept_encoding);
    const std::string_view listed = take_until(';', parameters);
    if (is_named(listed, coding)) return has_weight(parameters);
    if (listed == "*") any = has_weight(parameters);
  }
  return any;
}

bool names_etag(std::string_view if_none_match, std::string_view etag) noexcept {
  while (!if_none_match.empty()) {
    std::string_view tag = take_until(',', if_none_match);
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    if (tag == etag || tag == "*") return true;
  }
  return false;
}

}  // namespace telepalp::gateway
