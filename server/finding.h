#pragma once

#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::server {

/// One thing that `telepalp-server --check` has looked at.
struct Finding {
  enum class Kind {
    Good,
    Note,     ///< the server starts, but a person should know it
    Problem,  ///< the server does not start, or a part of it does not work
  };
  Kind kind = Kind::Good;
  std::string what;  ///< "key", "port 7400"
  std::string text;
};
using Findings = std::vector<Finding>;

[[nodiscard]] inline Finding good(std::string what, std::string text) {
  return {Finding::Kind::Good, std::move(what), std::move(text)};
}
[[nodiscard]] inline Finding note(std::string what, std::string text) {
  return {Finding::Kind::Note, std::move(what), std::move(text)};
}
[[nodiscard]] inline Finding problem(std::string what, const Error& error) {
  return {Finding::Kind::Problem, std::move(what), to_string(error)};
}

[[nodiscard]] bool has_problem(const Findings& findings);

/// A line for each finding, with its kind first, and last a line that sums them up.
[[nodiscard]] std::string in_lines(const Findings& findings);

}  // namespace telepalp::server
