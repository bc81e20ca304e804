#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::program {

/// Exit codes of every program: 0 done, 1 failed, 2 asked wrongly.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kAskedWrongly = 2;

/// One long option. `argument` empty: a flag. `initial` is shown in --help and used when the option is left out.
struct Option {
  std::string_view name;      // "source"
  std::string_view argument;  // "SOURCE"; empty for a flag
  std::string_view help;
  std::string_view initial = {};
  bool repeatable = false;  // may be given several times: Arguments::all()
};

/// What a program says of itself; `--help` prints it and ends with `example`, a line to paste.
struct Usage {
  std::string_view program;     // "telepalp-server"
  std::string_view purpose;     // one sentence
  std::string_view positional;  // "SESSION.mcap", or empty when there is none
  std::vector<Option> options;
  std::string_view example;
};

/// The command line, read. A number is checked against its bounds where it is asked for.
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

/// Reads argv. nullopt: `--help` was asked and has been printed to stdout; leave with kDone.
[[nodiscard]] Result<std::optional<Arguments>> read_arguments(const Usage& usage, int argc, const char* const* argv);

/// The text that `--help` prints.
[[nodiscard]] std::string help_text(const Usage& usage);

/// Prints `error: …` to stderr and returns `code`, for `return fail(error)` in main.
int fail(const Error& error, int code = kFailed);

}  // namespace telepalp::program
