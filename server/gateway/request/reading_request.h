#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "server/origin/reading.h"

namespace telepalp::gateway {

/// The value of the field `name` in the query of a request's target: "3" for `at_s` in /stream?view=qa&at_s=3. Empty:
/// the query does not have it.
[[nodiscard]] std::string_view query_value(std::string_view target, std::string_view name) noexcept;

/// A stream of a session for its reader alone: `?reading=ID`, with `session=NAME`, `at_s=SECONDS` or both.
struct ReadingRequest {
  std::string id;  ///< made up at random by the reader's page: 32 hexadecimal digits
  origin::ReadingSpec spec;
};

/// nullopt: the target asks for no reading. Error: an id or a moment of another form.
[[nodiscard]] Result<std::optional<ReadingRequest>> read_reading_request(std::string_view target);

}  // namespace telepalp::gateway
