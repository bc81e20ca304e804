// telepalp-replay: runs a session over a simulated network in virtual time and measures the force on the hand.

#include "tools/replay/commands/again.h"
#include "tools/replay/commands/journal_command.h"
#include "tools/replay/commands/run_command.h"
#include "tools/replay/commands/storm_command.h"
#include "tools/replay/sweep/sweep_command.h"

namespace {

using namespace telepalp;

int run(const program::Arguments& arguments, const std::vector<std::string>& words) {
  Result<replay::Request> request = replay::read_command_line(arguments, words);
  if (!request) return program::fail(request.error(), program::kAskedWrongly);
  request->tape.clock = replay::thread_ns;
  const Result<bool> holds = !request->journal.empty() ? replay::run_journal(*request)
                             : request->storm_seeds    ? replay::run_storm(*request)
                             : request->axes.empty()   ? replay::run_once(*request)
                                                       : replay::run_sweep(*request);
  // A gate must tell a run that cannot be made from an assertion that fails.
  if (!holds) return program::fail(holds.error(), program::kAskedWrongly);
  return *holds ? program::kDone : program::kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run_program(replay::usage(), argc, argv, [&](const program::Arguments& arguments) {
    return run(arguments, {argv + 1, argv + argc});
  });
}
