#pragma once

namespace telepalp::study {

/// The commands of telepalp-study beside the needle's study; each returns the process's exit code.
int run_obstruction(int argc, const char* const* argv);
int run_stiffness_jnd(int argc, const char* const* argv);
int run_rib_count(int argc, const char* const* argv);

}  // namespace telepalp::study
