#include "server/finding.h"

#include <algorithm>

#include "proto/words/counted.h"
#include "support/program/log.h"

namespace telepalp::server {
namespace {

const char* word(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::Good:
      return "ok       ";
    case Finding::Kind::Note:
      return "note     ";
    case Finding::Kind::Problem:
      return "PROBLEM  ";
  }
  return "?        ";
}

std::uint64_t count(const Findings& findings, Finding::Kind kind) {
  return static_cast<std::uint64_t>(std::ranges::count(findings, kind, &Finding::kind));
}

}  // namespace

bool has_problem(const Findings& findings) { return count(findings, Finding::Kind::Problem) > 0; }

std::string in_lines(const Findings& findings) {
  std::string text;
  for (const Finding& finding : findings)
    text += word(finding.kind) + program::escaped(finding.what) + ": " + program::escaped(finding.text) + "\n";
  const std::string problems = counted(count(findings, Finding::Kind::Problem), "problem", "problems");
  return text + (has_problem(findings) ? problems + ": the server would not start, or not do all that is asked\n"
                                       : "no problem: the server can start with these options\n");
}

}  // namespace telepalp::server
