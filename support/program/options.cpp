#include "support/program/options.h"

#include <unistd.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <system_error>

#include "proto/words/error_line.h"
#include "proto/words/number_word.h"
#include "support/program/log.h"
#include "support/program/terminal.h"

namespace telepalp::program {
namespace {

namespace po = boost::program_options;

constexpr const char* kPositional = "(positional)";

po::options_description describe(const Usage& usage) {
  po::options_description description;
  description.add_options()("help", "");
  description.add_options()("version", "");
  description.add_options()(kPositional, po::value<std::vector<std::string>>(), "");
  for (const Option& option : usage.options) {
    const std::string name{option.name};
    if (option.argument.empty())
      description.add_options()(name.c_str(), std::string(option.help).c_str());
    else
      description.add_options()(name.c_str(), po::value<std::string>(), std::string(option.help).c_str());
  }
  return description;
}

Error asked_wrongly(const Usage& usage, std::string what) {
  return {.what = std::move(what),
          .where = std::string(usage.program),
          .fix = "see " + std::string(usage.program) + " --help"};
}

/// The text that `--help`, `-h` or `--version` asks for; nullopt for any other option. `-h` is the only short option.
std::optional<std::string> asked_about(const Usage& usage, const po::option& option) {
  const bool short_help = option.string_key == kPositional && !option.value.empty() && option.value.front() == "-h";
  if (short_help || option.string_key == "help") return help_text(usage);
  if (option.string_key == "version") return version_text(usage.program);
  return std::nullopt;
}

bool is_repeatable(const Usage& usage, const std::string& name) {
  return std::any_of(usage.options.begin(), usage.options.end(),
                     [&](const Option& option) { return option.name == name && option.repeatable; });
}

bool takes_words(const Usage& usage) {
  return !usage.positional.empty() || std::any_of(usage.commands.begin(), usage.commands.end(),
                                                  [](const Command& command) { return command.run == nullptr; });
}

template <class T>
Result<T> parse_bounded(std::string_view option, const std::string& text, T least, T most) {
  const std::optional<T> value = number_of<T>(text);
  if (value && *value >= least && *value <= most) return *value;
  std::string bounds;
  if constexpr (std::is_floating_point_v<T>)
    bounds = "number from " + number_text(least) + " to " + number_text(most);
  else
    bounds = "whole number from " + std::to_string(least) + " to " + std::to_string(most);
  return Error{
      .what = "'" + text + "' is not a " + bounds, .where = "--" + std::string(option), .fix = "give a " + bounds};
}

Error output_error() {
  return {.what = "the output could not be written" +
                  (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()),
          .where = "standard output",
          .fix = "make room on the disk, or write to another place"};
}

bool output_is_lost = false;  // print() has said so

/// At the process's end: what the program wrote to stdout is written, or the exit code is kFailed.
void check_output() {
  errno = 0;
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (written || output_is_lost) return;
  (void)fail(output_error());
  ::_exit(kFailed);
}

}  // namespace

bool Arguments::has(std::string_view flag) const {
  return std::any_of(given_.begin(), given_.end(), [&](const Given& given) { return given.name == flag; });
}

std::string Arguments::text(std::string_view option) const {
  for (const Given& given : given_)
    if (given.name == option) return given.value;
  return {};
}

std::vector<std::string> Arguments::all(std::string_view option) const {
  std::vector<std::string> values;
  for (const Given& given : given_)
    if (given.name == option) values.push_back(given.value);
  return values;
}

Result<double> Arguments::number(std::string_view option, double least, double most) const {
  return parse_bounded<double>(option, text(option), least, most);
}

Result<std::int64_t> Arguments::whole(std::string_view option, std::int64_t least, std::int64_t most) const {
  return parse_bounded<std::int64_t>(option, text(option), least, most);
}

Result<std::optional<Arguments>> read_arguments(const Usage& usage, int argc, const char* const* argv) try {
  static std::once_flag once;
  std::call_once(once, [] { (void)std::atexit(check_output); });
  const po::options_description description = describe(usage);
  // Only complete long options are accepted: a guessed prefix could select the wrong safety setting.
  using namespace po::command_line_style;
  const int style = allow_long | long_allow_next | long_allow_adjacent;
  const po::parsed_options parsed = po::command_line_parser(argc, argv)
                                        .options(description)
                                        .positional(po::positional_options_description().add(kPositional, -1))
                                        .style(style)
                                        .run();
  Arguments arguments;
  for (const po::option& option : parsed.options) {
    if (const std::optional<std::string> text = asked_about(usage, option)) {
      std::fputs(text->c_str(), stdout);
      return std::optional<Arguments>{};
    }
    if (option.string_key == kPositional) {
      arguments.positional_.insert(arguments.positional_.end(), option.value.begin(), option.value.end());
      continue;
    }
    if (arguments.has(option.string_key) && !is_repeatable(usage, option.string_key))
      return asked_wrongly(usage, "--" + option.string_key + " is given twice");
    if (!option.value.empty() && option.value.front().empty())
      return asked_wrongly(usage, "--" + option.string_key + " is given an empty value");
    arguments.given_.push_back({option.string_key, option.value.empty() ? "" : option.value.front()});
  }
  if (!arguments.positional_.empty() && !takes_words(usage))
    return asked_wrongly(usage, "'" + arguments.positional_.front() + "' is neither an option nor a command");
  for (const Option& option : usage.options)
    if (!option.initial.empty() && !arguments.has(option.name))
      arguments.given_.push_back({std::string(option.name), std::string(option.initial)});
  return std::optional<Arguments>{std::move(arguments)};
} catch (const po::error& error) {
  return asked_wrongly(usage, error.what());
}

int run_program(const Usage& usage, int argc, const char* const* argv,
                const std::function<int(const Arguments&)>& run) {
  for (const Command& command : usage.commands)
    if (argc > 1 && command.run != nullptr && argv[1] == command.name) return command.run(argc - 1, argv + 1);
  const Result<std::optional<Arguments>> arguments = read_arguments(usage, argc, argv);
  if (!arguments) return fail(arguments.error(), kAskedWrongly);
  return *arguments ? run(**arguments) : kDone;
}

int print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return kDone;
  output_is_lost = true;
  return fail(output_error());
}

int fail(const Error& error, int code) {
  const bool colour = takes_colour(stderr);
  std::fprintf(stderr, "%serror:%s %s\n", colour ? "\x1b[31m" : "", colour ? "\x1b[0m" : "",
               escaped(to_string(error)).c_str());
  return code;
}

}  // namespace telepalp::program
