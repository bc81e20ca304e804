#include "haptic_station/station/faults/rearm_command.h"

#include <cstdio>

#include "haptic_station/station/faults/control_socket.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/patience.h"

namespace telepalp::station {
namespace {

program::Usage usage() {
  return {.program = "telepalp-station rearm",
          .purpose = "ends the fault of a station, so that it gives force again, once the cause of the fault is gone",
          .positional = "",
          .options = {{"control", "PATH",
                       "the station's control socket; default: that of the only station on this computer"},
                      program::patience_option("longest wait for the station's answer, in seconds; 0: for ever", "3")},
          .example = "telepalp-station rearm"};
}

Result<std::string> ask(const program::Arguments& arguments, std::chrono::duration<double> patience) {
  if (arguments.has("control")) return ask_station(arguments.text("control"), "rearm", patience);
  const Result<std::filesystem::path> path = find_control_socket();
  return path ? ask_station(*path, "rearm", patience) : path.error();
}

int rearm(const program::Arguments& arguments) {
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return program::fail(patience.error(), program::kAskedWrongly);
  const Result<std::string> answer = ask(arguments, patience->value_or(program::kForEver));
  if (!answer) return program::fail(answer.error());
  const bool done = answer->starts_with("re-armed");
  std::fprintf(done ? stdout : stderr, "%s%s\n", done ? "" : "error: ", program::escaped(*answer).c_str());
  return done ? program::kDone : program::kFailed;
}

}  // namespace

int rearm_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, rearm); }

}  // namespace telepalp::station
