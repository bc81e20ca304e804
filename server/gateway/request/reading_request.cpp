#include "server/gateway/request/reading_request.h"

#include <algorithm>

#include "proto/words/number_word.h"

namespace telepalp::gateway {
namespace {

constexpr std::size_t kIdDigits = 32;
constexpr double kLongest_s = 1e7;

bool is_id(std::string_view id) {
  return id.size() == kIdDigits && id.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Error wrong(const char* what, std::string_view where) {
  return {.what = what, .where = std::string(where.substr(0, 100)), .fix = "open the shared address again, unchanged"};
}

}  // namespace

std::string_view query_value(std::string_view target, std::string_view name) noexcept {
  const std::size_t asked = target.find('?');
  std::string_view query = asked == std::string_view::npos ? std::string_view{} : target.substr(asked + 1);
  while (!query.empty()) {
    const std::string_view one = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), one.size() + 1));
    if (one.starts_with(name) && one.substr(name.size()).starts_with('=')) return one.substr(name.size() + 1);
  }
  return {};
}

Result<std::optional<ReadingRequest>> read_reading_request(std::string_view target) {
  const std::string_view id = query_value(target, "reading");
  if (id.empty()) return std::optional<ReadingRequest>{};
  if (!is_id(id)) return wrong("the number of the reading is not 32 hexadecimal digits", id);
  ReadingRequest request{.id = std::string(id),
                         .spec = {.session = std::string(query_value(target, "session")), .at_s = {}}};
  const std::string_view at = query_value(target, "at_s");
  if (at.empty()) return std::optional(std::move(request));
  request.spec.at_s = number_of(at);
  if (!request.spec.at_s || !(*request.spec.at_s >= 0.0 && *request.spec.at_s <= kLongest_s))
    return wrong("the moment is not a number of seconds from the session's beginning", at);
  return std::optional(std::move(request));
}

}  // namespace telepalp::gateway
