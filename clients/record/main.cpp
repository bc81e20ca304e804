#include "clients/record/file_commands.h"
#include "clients/record/live/amounts.h"
#include "clients/record/live/recording.h"
#include "support/program/default_ports.h"
#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/patience.h"
#include "support/program/people/consent.h"
#include "support/program/terminal.h"
#include "support/session_store/session_place.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-record";

program::Usage usage() {
  return {
      .program = kProgram,
      .purpose = "records a server's messages to a session file; describes and edits such files",
      .positional = {},
      .options = {{"connect", "SERVER", "HOST[:PORT], or SITE@HOST[:PORT]", program::kServerAddress},
                  {"key", "FILE", "your key file, for a server on another machine"},
                  {"out", "FILE.mcap", "new session: a file, or nats://HOST/SITE/NAME.mcap"},
                  {"keep-days", "N", "how long a cluster keeps the session"},
                  {"topics", "LIST", "topics, as shell patterns: A,B; !PATTERN excludes", "*"},
                  {"color", "jpeg|vp8", "colour as pictures, or as video, over a thin line", "jpeg"},
                  {"seconds", "S", "stop after this time; 0: until Ctrl-C", "0"},
                  {"split", "SIZE|TIME", "begin a new file after this: 500MB, 10min"},
                  {"keep-last", "TIME", "delete files of this recording older than TIME: 5min"},
                  program::consent_option(),
                  {"voice-consent", "TEXT", "note on the consent to recording what is said; else it is not"},
                  {"scene", "FILE", "the station's scene file, to be attached"},
                  {.name = "attach",
                   .argument = "FILE",
                   .help = "another file to attach, such as a report; may be repeated",
                   .repeatable = true},
                  program::patience_option("how long to wait for the server at the start; 0: for ever"),
                  {"ready-file", "FILE", "file that is written when the recording begins"}},
      .example = "telepalp-record --out session.mcap --seconds 60",
      .commands = {
          {"info", "FILE", "describe a session file", record::info_command},
          {"verify", "FILE", "check that all of a session file can be read", record::verify_command},
          {"repair", "FILE", "finish a recording that was cut off, or repair a damaged file", record::repair_command},
          {"cut", "FILE", "copy a part of a session", record::cut_command},
          {"merge", "FILE...", "join sessions, or the parts of a session", record::merge_command},
          {"expire", "DIR", "delete sessions whose retention or consent has ended", record::expire_command},
          {"copy", "SESSION", "copy a session to or from a cluster, encrypt or decrypt it", record::copy_command},
          {"reseal", "FILE...", "encrypt sessions for a new key of the site", record::reseal_command},
          {"forget", "SESSION", "remove a session from a cluster", record::forget_command}}};
}

/// A shorter time would begin a new file at nearly each message, or delete nearly the whole recording.
Result<void> at_least_a_second(Nanoseconds time, const char* option) {
  if (time >= std::chrono::seconds(1)) return {};
  return Error{.what = "the time is shorter than 1 s", .where = option, .fix = "give 1s or more, such as 10min"};
}

Result<record::Splitting> splitting_of(const program::Arguments& arguments) {
  record::Splitting splitting;
  if (const std::string split = arguments.text("split"); record::is_size(split)) {
    const Result<std::uint64_t> bytes = record::parse_size(split, "split");
    if (!bytes) return bytes.error();
    splitting.bytes = *bytes;
  } else if (!split.empty()) {
    const Result<Nanoseconds> time = record::parse_duration(split, "split");
    if (!time)
      return Error{
          .what = "'" + split.substr(0, 64) + "' is neither a size nor a duration of at most 1000 days",
          .where = "--split",
          .fix = "give a size with kB, MB or GB, such as 500MB, or a duration with s, min or h, such as 10min"};
    if (const Result<void> enough = at_least_a_second(*time, "--split"); !enough) return enough.error();
    splitting.time = *time;
  }
  if (!arguments.has("keep-last")) return splitting;
  const Result<Nanoseconds> keep = record::parse_duration(arguments.text("keep-last"), "keep-last");
  if (!keep) return keep.error();
  if (const Result<void> enough = at_least_a_second(*keep, "--keep-last"); !enough) return enough.error();
  splitting.keep_last = *keep;
  return splitting;
}

Result<record::RecordingOptions> recording_options(const program::Arguments& arguments) {
  const Result<program::Address> server = program::parse_server(arguments.text("connect"), "--connect");
  if (!server) return server.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return seconds.error();
  const Result<program::Patience> patience = program::patience_of(arguments);
  if (!patience) return patience.error();
  const Result<record::Splitting> splitting = splitting_of(arguments);
  if (!splitting) return splitting.error();
  const Result<wire::ColorCoding> color = wire::color_coding(arguments.text("color"), "--color");
  if (!color) return color.error();
  const std::vector<std::string> attached = arguments.all("attach");
  return record::RecordingOptions{.server = *server,
                                  .key = {},
                                  .file = arguments.text("out"),
                                  .topics = record::TopicFilter(arguments.text("topics")),
                                  .color = *color,
                                  .splitting = *splitting,
                                  .consent = arguments.text("consent"),
                                  .voice_consent = arguments.text("voice-consent"),
                                  .scene = arguments.text("scene"),
                                  .attachments = {attached.begin(), attached.end()},
                                  .seconds = std::chrono::duration<double>(*seconds),
                                  .patience = *patience,
                                  .ready_file = arguments.text("ready-file"),
                                  .progress = program::takes_progress(stderr)};
}

int run_recording(const program::Arguments& arguments) {
  if (!arguments.has("out"))
    return program::fail(
        {.what = "neither a file to record to nor a command is given",
         .where = kProgram,
         .fix = "give --out FILE.mcap, or a command: info, verify, repair, cut, merge, expire, copy, reseal, forget"},
        program::kAskedWrongly);
  Result<record::RecordingOptions> options = recording_options(arguments);
  if (!options) return program::fail(options.error(), program::kAskedWrongly);
  if (const Result<void> stated = program::check_consent(arguments, "this recording"); !stated)
    return program::fail(stated.error(), program::kAskedWrongly);
  if (const Result<void> settled = record::settle_cluster_terms(arguments); !settled)
    return program::fail(settled.error(), program::kAskedWrongly);
  Result<std::shared_ptr<const keys::KeyFile>> key =
      keys::load_client_key(arguments.text("key"), std::chrono::system_clock::now());
  if (!key) return program::fail(key.error());
  options->key = std::move(key).value();
  const Result<record::RecordingReport> report = record::record(*options);
  if (!report) return program::fail(report.error());
  program::log(kProgram, options->file.string() + ": " + record::describe(*report));
  return program::kDone;
}

}  // namespace

int main(int argc, char** argv) {
  program::say_when_stopped(
      "telepalp-record: stopped: the sessions that it read are unchanged; an unfinished copy ends with .partial");
  session_store::use_cluster_sessions();
  return program::run_program(usage(), argc, argv, run_recording);
}
