#pragma once

namespace telepalp::record {

// The commands of telepalp-record on files: each reads its own options and returns the exit code of the program.
int info_command(int argc, const char* const* argv);
int verify_command(int argc, const char* const* argv);
int repair_command(int argc, const char* const* argv);
int cut_command(int argc, const char* const* argv);
int merge_command(int argc, const char* const* argv);

}  // namespace telepalp::record
