// telepalp-replay: runs a session over a simulated network in virtual time and measures the force on the hand.

#include "tools/replay/commands/again.h"
#include "tools/replay/commands/journal_command.h"
#include "tools/replay/commands/run_command.h"
#include "tools/replay/commands/storm_command.h"
#include "tools/replay/commands/sweep_command.h"

int main(int argc, char** argv) {
  using namespace telepalp;
  if (const std::optional<int> code = program::run_command(replay::usage(), argc, argv)) return *code;
  Result<std::optional<replay::Request>> read = replay::read_command_line(argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  std::optional<replay::Request>& request = *read;
  request->tape.clock = replay::thread_ns;
  const Result<bool> holds = !request->journal.empty() ? replay::run_journal(*request)
                             : request->storm_seeds    ? replay::run_storm(*request)
                             : request->axes.empty()   ? replay::run_once(*request)
                                                       : replay::run_sweep(*request);
  // A gate must tell a run that cannot be made from an assertion that fails.
  if (!holds) return program::fail(holds.error(), program::kAskedWrongly);
  return *holds ? program::kDone : program::kFailed;
}
