#pragma once

#include <string>

#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::record {

inline constexpr const char* kProgram = "telepalp-record";

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

/// The error of a wrong command line; its fix names the --help of `usage`.
[[nodiscard]] Error asked_wrongly(std::string what, const program::Usage& usage);

/// If --out names a session in a cluster, tells the cluster how long to keep it. (On the disk, telepalp-record expire
/// ends the retention.) Error: the consent is over, or an option does not suit a cluster.
[[nodiscard]] Result<void> settle_cluster_terms(const program::Arguments& arguments);

}  // namespace telepalp::record
