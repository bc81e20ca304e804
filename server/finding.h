#pragma once

#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::server {

/// The result of one check of `telepalp-server --check`.
struct Finding {
  enum class Kind {
    Good,
    Note,     ///< the server starts, but a person has to do something soon, or should know it
    Problem,  ///< the server does not start, or a part of it does not work
  };
  Kind kind = Kind::Good;
  std::string what;  ///< what was checked: "key", "port of the web page"
  std::string text;  ///< what was found
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

/// One line per finding, which begins with its kind, and a last line with the number of problems.
[[nodiscard]] std::string in_lines(const Findings& findings);

}  // namespace telepalp::server
