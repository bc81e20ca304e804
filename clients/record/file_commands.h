#pragma once

namespace telepalp::record {

// The commands of telepalp-record on files: each parses the options in `argv` and returns the program's exit code.
int info_command(int argc, const char* const* argv);
int verify_command(int argc, const char* const* argv);
int repair_command(int argc, const char* const* argv);
int cut_command(int argc, const char* const* argv);
int merge_command(int argc, const char* const* argv);
int expire_command(int argc, const char* const* argv);
int copy_command(int argc, const char* const* argv);
int reseal_command(int argc, const char* const* argv);
int forget_command(int argc, const char* const* argv);

}  // namespace telepalp::record
