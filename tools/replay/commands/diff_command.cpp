#include "tools/replay/commands/diff_command.h"

#include <cstdio>
#include <optional>
#include <string>

#include "clients/report/compare/gate.h"
#include "proto/wire/mcap/first_difference.h"
#include "support/program/options.h"

namespace telepalp::replay {
namespace {

program::Usage diff_usage() {
  return {.program = "telepalp-replay diff",
          .purpose = "prints the first message in which two sessions differ",
          .positional = "A.mcap|DIR B.mcap|DIR",
          .options = {},
          .example = "telepalp-replay diff session.mcap out/session.mcap"};
}

int diff(const program::Arguments& arguments) {
  if (arguments.positional().size() != 2)
    return program::fail({.what = "the command does not name exactly two sessions",
                          .where = "telepalp-replay diff",
                          .fix = "give two session files, or folders of --out: telepalp-replay diff A.mcap B.mcap"},
                         program::kAskedWrongly);
  const auto difference = wire::first_difference(report::session_file(arguments.positional()[0]),
                                                 report::session_file(arguments.positional()[1]));
  if (!difference) return program::fail(difference.error(), program::kAskedWrongly);
  if (!*difference) {
    std::puts("the two sessions are equal: every message has the same topic, time and bytes");
    return program::kDone;
  }
  std::fputs((*difference)->c_str(), stdout);
  return program::kFailed;
}

}  // namespace

int diff_command(int argc, const char* const* argv) { return program::run_program(diff_usage(), argc, argv, diff); }

}  // namespace telepalp::replay
