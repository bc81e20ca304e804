#include <unistd.h>

#include <boost/algorithm/string.hpp>
#include <cstdio>

#include "clients/record/inspect.h"
#include "clients/record/recording.h"
#include "clients/record/repair.h"
#include "clients/record/unfinished.h"
#include "support/program/log.h"
#include "support/program/options.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-record";

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "writes what a server publishes to a session file, and looks after such files",
          .positional = {},
          .options = {{"connect", "HOST:PORT", "the server", "127.0.0.1:8764"},
                      {"out", "FILE.mcap", "record to this new file; until it is whole it is called FILE.mcap.partial"},
                      {"topics", "LIST", "by commas; a name ending in * is a prefix", "*"},
                      {"seconds", "S", "stop after so long; 0: until Ctrl-C", "0"},
                      {"patience-s", "S", "give up if the server does not answer at the start", "30"},
                      {"ready-file", "FILE", "write there once the server is subscribed to"},
                      {"info", "FILE", "tell what a session file holds"},
                      {"repair", "FILE",
                       "finish FILE.mcap.partial that was cut off; or copy what can be read of a damaged file, to "
                       "--out or beside it"}},
          .example = "telepalp-record --out session.mcap --seconds 60"};
}

int show_info(const std::string& file) {
  const Result<std::string> text = record::inspect(file);
  if (!text) return program::fail(text.error());
  std::fputs(text->c_str(), stdout);
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
  const Result<program::Address> server = program::parse_address(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return seconds.error();
  const Result<double> patience = arguments.number("patience-s", 0.0, 1e7);
  if (!patience) return patience.error();
  record::RecordingOptions options{.server = *server,
                                   .file = arguments.text("out"),
                                   .topics = {},
                                   .seconds = std::chrono::duration<double>(*seconds),
                                   .patience = std::chrono::duration<double>(*patience),
                                   .ready_file = arguments.text("ready-file"),
                                   .progress = ::isatty(STDERR_FILENO) == 1};
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

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = program::read_arguments(usage(), argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const program::Arguments& asked = **arguments;
  if (asked.has("info")) return show_info(asked.text("info"));
  if (asked.has("repair")) return run_repair(asked.text("repair"), asked.text("out"));
  if (asked.has("out")) return run_recording(asked);
  return program::fail(
      {.what = "nothing to do", .where = kProgram, .fix = "give --out FILE.mcap, --info FILE or --repair FILE"},
      program::kAskedWrongly);
}
