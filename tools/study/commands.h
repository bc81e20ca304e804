#pragma once

#include <cstdint>
#include <filesystem>

#include "support/program/options.h"
#include "tools/study/task/design.h"

namespace telepalp::study {

inline constexpr const char* kProgram = "telepalp-study";

/// The options that all studies have.
inline constexpr program::Option kSeedOption{"seed", "N", "the same seed gives the same bytes", "1"};
inline constexpr program::Option kThreadsOption{"threads", "N", "side by side; 0: one for each processor", "0"};
inline constexpr std::string_view kOutHelp =
    "folder of report.html, study.json, trials.csv and runs/; the same command resumes a study that was stopped";
inline constexpr program::Option kJsonOption{"json", "", "print study.json instead of the table"};

inline constexpr program::Option kDesignOption{
    "design", "NAME|FILE",
    "amniocentesis: the 36 mechanisms of paper S4; or a text file with one mechanism a line: name=a l1=80 ...",
    "amniocentesis"};

/// Error: the number is out of range.
[[nodiscard]] Result<std::uint64_t> read_seed(const program::Arguments& arguments);
[[nodiscard]] Result<int> read_threads(const program::Arguments& arguments);
/// The mechanisms that --design names. Error: the file cannot be read, with line and column.
[[nodiscard]] Result<Design> read_design_choice(const program::Arguments& arguments);

struct RunChoice {
  std::uint64_t seed = 1;
  int threads = 1;
  std::filesystem::path out;
};
/// Error: a number is out of range, or --out names no folder.
[[nodiscard]] Result<RunChoice> read_run_choice(const program::Arguments& arguments);

/// The folder that --out names. Error: none.
[[nodiscard]] Result<std::filesystem::path> read_out(const program::Arguments& arguments);

/// The commands of telepalp-study besides the needle's study; each returns the process's exit code.
int run_search(int argc, const char* const* argv);
int run_obstruction(int argc, const char* const* argv);
int run_stiffness_jnd(int argc, const char* const* argv);
int run_rib_count(int argc, const char* const* argv);

}  // namespace telepalp::study
