#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace telepalp::program {

/// Largest size of each program's `--help` text; a test checks it.
inline constexpr std::size_t kHelpColumns = 80;
inline constexpr std::size_t kHelpLines = 40;

/// One long option. With an empty `argument` it is a flag. `initial`: the default value, shown in --help.
struct Option {
  std::string_view name;      // "source"
  std::string_view argument;  // "SOURCE"; empty for a flag
  std::string_view help;
  std::string_view initial = {};
  bool repeatable = false;  // may be given several times; Arguments::all() returns the values
};

/// A command of a program, selected by the first argument. If `run` is set, the command has its own options and help.
struct Command {
  std::string_view name;      // "info"
  std::string_view argument;  // "FILE"; empty: no argument, or the command has its own help
  std::string_view help;
  int (*run)(int argc, const char* const* argv) = nullptr;  // argv[0] is the command's name; returns the exit code
};

/// The parts of the help text. `--help` prints them and ends with `example`, a command line to paste.
struct Usage {
  std::string_view program;     // "telepalp-server"
  std::string_view purpose;     // one sentence
  std::string_view positional;  // "SESSION.mcap"; empty: no positional argument
  std::vector<Option> options;
  std::string_view example;
  std::vector<Command> commands = {};
  bool needs_command = false;  // true: the program requires a command
};

/// The text that `--help` prints: purpose, usage, commands, options, example, each in the same form for every program.
[[nodiscard]] std::string help_text(const Usage& usage);

/// The text that `--version` prints: program, version, commit, and versions of the supported formats.
[[nodiscard]] std::string version_text(std::string_view program);

}  // namespace telepalp::program
