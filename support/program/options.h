#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "support/program/help.h"

namespace telepalp::program {

/// Exit codes of every program: 0 success, 1 failure, 2 wrong command line.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kAskedWrongly = 2;

/// The parsed command line with defaults. text(): empty if absent. number(), whole(): error outside [least, most].
class Arguments {
 public:
  [[nodiscard]] bool has(std::string_view flag) const;
  [[nodiscard]] std::string text(std::string_view option) const;
  /// Every value of an option that may be given several times, in order.
  [[nodiscard]] std::vector<std::string> all(std::string_view option) const;
  [[nodiscard]] Result<double> number(std::string_view option, double least, double most) const;
  [[nodiscard]] Result<std::int64_t> whole(std::string_view option, std::int64_t least, std::int64_t most) const;
  [[nodiscard]] const std::vector<std::string>& positional() const noexcept { return positional_; }

 private:
  friend Result<std::optional<Arguments>> read_arguments(const Usage&, int, const char* const*);
  struct Given {
    std::string name;
    std::string value;
  };
  std::vector<Given> given_;
  std::vector<std::string> positional_;
};

/// Reads argv. Error: an unknown option or word, an empty value, or an option given twice that is not `repeatable`.
/// nullopt: `--help` or `--version` was given, and its text has been printed to stdout; exit with kDone. If stdout
/// cannot take what the process prints, as on a full disk, the process says so when it ends, and its exit code becomes
/// kFailed.
[[nodiscard]] Result<std::optional<Arguments>> read_arguments(const Usage& usage, int argc, const char* const* argv);

/// What a program, or one of its commands, does with a command line; returns the exit code. It runs the command that
/// argv[1] names, if that command has a Command::run, else `run` with the arguments. A wrong command line gives
/// kAskedWrongly, after its error was printed to stderr; `--help` and `--version` give kDone.
[[nodiscard]] int run_program(const Usage& usage, int argc, const char* const* argv,
                              const std::function<int(const Arguments&)>& run);

/// Prints `text` to stdout and returns kDone, for `return print(text)` in main; kFailed if stdout cannot take all of
/// it, as on a full disk.
int print(const std::string& text);

/// Prints `error: …` to stderr and returns `code`, for `return fail(error)` in main.
int fail(const Error& error, int code = kFailed);

}  // namespace telepalp::program
