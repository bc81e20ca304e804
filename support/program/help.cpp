#include "support/program/help.h"

#include <algorithm>
#include <utility>

#include "proto/words/formats.h"
#include "support/program/version.h"

namespace telepalp::program {
namespace {

/// The line of an option or command: its syntax and its description.
using Row = std::pair<std::string, std::string>;

constexpr std::size_t kWidestLeft = 24;  // a longer left side stands on a line of its own

/// Number of columns of UTF-8 `text`: its characters, not its bytes.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char letter) { return (letter & '\xc0') != '\x80'; }));
}

/// `text` broken at spaces, so that no line passes kHelpColumns. The first line begins at column `at`, all others are
/// indented by `indent`.
std::string wrapped(std::string_view text, std::size_t at, std::size_t indent) {
  std::string out;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const bool fresh = out.empty() || out.back() == ' ';
    if (!fresh && at + 1 + columns(word) > kHelpColumns) {
      out += "\n" + std::string(indent, ' ');
      at = indent;
    } else if (!fresh) {
      out += ' ';
      ++at;
    }
    out += word;
    at += columns(word);
  }
  return out + "\n";
}

std::string row_text(const Row& row, std::size_t left_width) {
  const std::size_t indent = left_width + 4;
  std::string left = "  " + row.first;
  if (columns(row.first) > left_width)
    left += "\n" + std::string(indent, ' ');
  else
    left += std::string(indent - columns(left), ' ');
  return left + wrapped(row.second, indent, indent);
}

std::string table(const std::string& title, const std::vector<Row>& rows) {
  std::size_t left_width = 0;
  for (const Row& row : rows)
    if (columns(row.first) <= kWidestLeft) left_width = std::max(left_width, columns(row.first));
  std::string text = "\n" + title + ":\n";
  for (const Row& row : rows) text += row_text(row, left_width);
  return text;
}

std::string joined(std::string_view left, std::string_view right) {
  return std::string(left) + (right.empty() ? "" : " " + std::string(right));
}

/// True when the commands have a help of their own, to which their table's heading leads.
bool has_own_help(const Usage& usage) {
  return std::any_of(usage.commands.begin(), usage.commands.end(),
                     [](const Command& command) { return command.run != nullptr; });
}

std::string usage_lines(const Usage& usage) {
  const std::string program(usage.program);
  std::string text;
  if (!usage.needs_command) text = "usage: " + joined(program + " [options]", usage.positional) + "\n";
  if (!usage.commands.empty() && (text.empty() || !has_own_help(usage)))
    text += (text.empty() ? "usage: " : "       ") + program + " COMMAND [options]\n";
  return text;
}

std::vector<Row> command_rows(const Usage& usage) {
  std::vector<Row> rows;
  for (const Command& command : usage.commands) rows.emplace_back(joined(command.name, command.argument), command.help);
  return rows;
}

std::vector<Row> option_rows(const Usage& usage) {
  std::vector<Row> rows;
  for (const Option& option : usage.options)
    rows.emplace_back("--" + joined(option.name, option.argument),
                      joined(option.help, option.initial.empty() ? "" : "[" + std::string(option.initial) + "]"));
  rows.emplace_back("-h, --help", "print this help and exit");
  rows.emplace_back("--version", "print version, commit and formats, and exit");
  return rows;
}

}  // namespace

std::string help_text(const Usage& usage) {
  const std::string purpose = wrapped(std::string(usage.program) + ": " + std::string(usage.purpose), 0, 0);
  std::string text = usage_lines(usage);
  if (!usage.commands.empty())
    text += table(
        has_own_help(usage) ? "commands (details: " + std::string(usage.program) + " COMMAND --help)" : "commands",
        command_rows(usage));
  text += table("options", option_rows(usage)) + "\nexample: " + std::string(usage.example) + "\n";
  // The longest help gives up the empty line after its first sentence, so that it still fits on a screen.
  const auto lines = static_cast<std::size_t>(std::ranges::count(purpose + text, '\n'));
  return purpose + (lines < kHelpLines ? "\n" : "") + text;
}

std::string version_text(std::string_view program) {
  return software(program.substr(0, program.find(' '))) + (*commit() == '\0' ? ", commit unknown" : "") +
         "\nwire protocol " + std::to_string(kWireProtocolVersion) + ", depth codec " +
         std::to_string(kDepthPacketVersion) + ", MCAP " + std::to_string(kMcapVersion) + "\n";
}

}  // namespace telepalp::program
