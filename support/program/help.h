#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace telepalp::program {

/// `--help` is at most this wide and this high in every program; a test holds them to it.
inline constexpr std::size_t kHelpColumns = 80;
inline constexpr std::size_t kHelpLines = 40;

/// One long option. `argument` empty: a flag. `initial` is shown in --help and used when the option is left out.
struct Option {
  std::string_view name;      // "source"
  std::string_view argument;  // "SOURCE"; empty for a flag
  std::string_view help;
  std::string_view initial = {};
  bool repeatable = false;  // may be given several times: Arguments::all()
};

/// What a program also does, by its first word. With `run`, the command has options and a help of its own.
struct Command {
  std::string_view name;      // "info"
  std::string_view argument;  // "FILE"; empty when it takes none, or has a help of its own
  std::string_view help;
  int (*run)(int argc, const char* const* argv) = nullptr;  // argv[0] is the command's name
};

/// What a program says of itself; `--help` prints it and ends with `example`, a line to paste.
struct Usage {
  std::string_view program;     // "telepalp-server"
  std::string_view purpose;     // one sentence
  std::string_view positional;  // "SESSION.mcap", or empty when there is none
  std::vector<Option> options;
  std::string_view example;
  std::vector<Command> commands = {};
  bool needs_command = false;  // without a command there is nothing to do
};

/// The text that `--help` prints: purpose, usage, commands, options, example, each in the same form for every program.
[[nodiscard]] std::string help_text(const Usage& usage);

/// The text that `--version` prints: program, version, commit, and the formats it speaks.
[[nodiscard]] std::string version_text(std::string_view program);

}  // namespace telepalp::program
