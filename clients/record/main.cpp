#include <boost/algorithm/string.hpp>
#include <cstdio>

#include "clients/record/inspect.h"
#include "clients/record/recording.h"
#include "clients/record/repair.h"
#include "clients/record/unfinished.h"
#include "support/program/default_ports.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/patience.h"
#include "support/program/terminal.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-record";

int info_command(int argc, const char* const* argv);
int repair_command(int argc, const char* const* argv);

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "records a server's messages to a session file; describes and repairs such files",
          .positional = {},
          .options = {{"connect", "HOST[:PORT]", "the server", program::kServerAddress},
                      {"key", "FILE", "your key file, for a server on another machine"},
                      {"out", "FILE.mcap", "new session file; named FILE.mcap.partial until it is complete"},
                      {"topics", "LIST", "comma-separated; a name ending in * is a prefix", "*"},
                      {"seconds", "S", "stop after this time; 0: until Ctrl-C", "0"},
                      program::patience_option("how long to wait for the server at the start; 0: for ever"),
                      {"ready-file", "FILE", "file to write once the subscription is active"},
                      {"info", "FILE", "the same as the command info"},
                      {"repair", "FILE", "the same as the command repair; the copy goes to --out or beside the file"}},
          .example = "telepalp-record --out session.mcap --seconds 60",
          .commands = {
              {"info", "FILE", "describe a session file", info_command},
              {"repair", "FILE", "finish a recording that was cut off, or repair a damaged file", repair_command}}};
}

program::Usage info_usage() {
  return {.program = "telepalp-record info",
          .purpose = "describes a session file: length, size, origin, topics and rates",
          .positional = "FILE",
          .options = {{"json", "", "print JSON instead of a table"}},
          .example = "telepalp-record info session.mcap"};
}

program::Usage repair_usage() {
  return {.program = "telepalp-record repair",
          .purpose = "finishes a recording that was cut off, or copies what can be read of a damaged file",
          .positional = "FILE",
          .options = {{"out", "FILE.mcap", "file for the copy; default: beside FILE"}},
          .example = "telepalp-record repair session.mcap"};
}

/// The one file of a command.
Result<std::string> file_of(const program::Arguments& arguments, const program::Usage& usage) {
  if (arguments.positional().size() == 1) return arguments.positional().front();
  return Error{.what = "name one session file",
               .where = std::string(usage.program),
               .fix = "see " + std::string(usage.program) + " --help"};
}

int show_info(const std::string& file, bool json) {
  const Result<record::SessionFacts> facts = record::inspect(file);
  if (!facts) return program::fail(facts.error());
  std::fputs((json ? record::in_json(*facts) : record::in_words(*facts)).c_str(), stdout);
  return program::kDone;
}

int run_finish(const std::filesystem::path& partial) {
  const Result<record::RepairReport> report = record::finish(partial);
  if (!report) return program::fail(report.error());
  for (const std::string& damage : report->damages) program::log(kProgram, partial.string() + ": " + damage);
  program::log(kProgram, record::in_words(*report));
  return program::kDone;
}

int run_repair(const std::string& file, const std::string& out) {
  if (const auto partial = record::unfinished(file); partial && out.empty()) return run_finish(*partial);
  const Result<record::RepairReport> report =
      record::repair(file, out.empty() ? record::repaired_name(file) : std::filesystem::path(out));
  if (!report) return program::fail(report.error());
  if (report->was_whole) {
    program::log(kProgram, file + " is whole: all its " + std::to_string(report->messages) + " messages can be read");
    return program::kDone;
  }
  for (const std::string& damage : report->damages) program::log(kProgram, file + ": " + damage);
  program::log(kProgram, "recovered " + std::to_string(report->messages) + " messages to " + report->file.string());
  return program::kDone;
}

Result<record::RecordingOptions> recording_options(const program::Arguments& arguments) {
  const Result<program::Address> server =
      program::parse_address(arguments.text("connect"), "--connect", program::kServerPort);
  if (!server) return server.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return seconds.error();
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return patience.error();
  Result<std::shared_ptr<const keys::KeyFile>> key =
      keys::load_client_key(arguments.text("key"), std::chrono::system_clock::now());
  if (!key) return key.error();
  record::RecordingOptions options{.server = *server,
                                   .key = std::move(key).value(),
                                   .file = arguments.text("out"),
                                   .topics = {},
                                   .seconds = std::chrono::duration<double>(*seconds),
                                   .patience = *patience,
                                   .ready_file = arguments.text("ready-file"),
                                   .progress = program::takes_progress(stderr)};
  const std::string topics = arguments.text("topics");
  boost::split(options.topics, topics, boost::is_any_of(", "), boost::token_compress_on);
  return options;
}

int run_recording(const program::Arguments& arguments) {
  const Result<record::RecordingOptions> options = recording_options(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  const Result<record::RecordingReport> report = record::record(*options);
  if (!report) return program::fail(report.error());
  program::log(kProgram, options->file.string() + ": " + record::describe(*report));
  return program::kDone;
}

int info_command(int argc, const char* const* argv) {
  const auto arguments = program::read_arguments(info_usage(), argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const Result<std::string> file = file_of(**arguments, info_usage());
  return file ? show_info(*file, (*arguments)->has("json")) : program::fail(file.error(), program::kAskedWrongly);
}

int repair_command(int argc, const char* const* argv) {
  const auto arguments = program::read_arguments(repair_usage(), argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const Result<std::string> file = file_of(**arguments, repair_usage());
  return file ? run_repair(*file, (*arguments)->text("out")) : program::fail(file.error(), program::kAskedWrongly);
}

}  // namespace

int main(int argc, char** argv) {
  if (const std::optional<int> code = program::run_command(usage(), argc, argv)) return *code;
  const auto arguments = program::read_arguments(usage(), argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const program::Arguments& asked = **arguments;
  if (asked.has("info")) return show_info(asked.text("info"), false);
  if (asked.has("repair")) return run_repair(asked.text("repair"), asked.text("out"));
  if (asked.has("out")) return run_recording(asked);
  return program::fail(
      {.what = "nothing to do", .where = kProgram, .fix = "give --out FILE.mcap, or a command: info FILE, repair FILE"},
      program::kAskedWrongly);
}
