#pragma once

namespace telepalp::trials {

/// `telepalp-station trials …`: runs the four trials of paper S1 (docs/sources.md) in virtual time and writes their
/// report. `argv[0]` is "trials". Returns the program's exit code.
int trials_command(int argc, const char* const* argv);

}  // namespace telepalp::trials
