#include "clients/record/file_commands.h"

#include <algorithm>
#include <cstdio>

#include "clients/record/edit/merge.h"
#include "clients/record/facts/session_facts.h"
#include "clients/record/live/amounts.h"
#include "clients/record/repair/repair.h"
#include "clients/record/unfinished.h"
#include "proto/words/counted.h"
#include "support/program/log.h"
#include "support/program/options.h"

namespace telepalp::record {
namespace {

program::Usage info_usage() {
  return {.program = "telepalp-record info",
          .purpose = "describes a session: origin, topics, rates, bytes, gaps, drops, clock",
          .positional = "FILE",
          .options = {{"json", "", "print JSON instead of a table"}},
          .example = "telepalp-record info session.mcap"};
}

program::Usage verify_usage() {
  return {.program = "telepalp-record verify",
          .purpose = "reads all of a session and compares each byte with the CRCs in it",
          .positional = "FILE",
          .options = {},
          .example = "telepalp-record verify session.mcap"};
}

program::Usage repair_usage() {
  return {
      .program = "telepalp-record repair",
      .purpose = "finishes a recording that was cut off (FILE.partial), or copies what can be read of a damaged file",
      .positional = "FILE",
      .options = {{"out", "FILE.mcap", "file for the copy; default: NAME.repaired.mcap for NAME.mcap"}},
      .example = "telepalp-record repair session.mcap"};
}

program::Usage cut_usage() {
  return {.program = "telepalp-record cut",
          .purpose = "copies a part of a session to a new file",
          .positional = "FILE",
          .options = {{"out", "FILE.mcap", "the new file"},
                      {"from", "TIME", "begin this long after the session's start: 90s, 1.5min", "0s"},
                      {"to", "TIME", "end this long after the session's start; default: its end"},
                      {"topics", "LIST", "shell patterns, comma-separated; !PATTERN excludes", "*"}},
          .example = "telepalp-record cut session.mcap --from 0.5s --to 1.5s --out part.mcap"};
}

program::Usage merge_usage() {
  return {.program = "telepalp-record merge",
          .purpose = "joins sessions, or the parts of a session, to a new file in order of time",
          .positional = "FILE...",
          .options = {{"out", "FILE.mcap", "the new file"}},
          .example = "telepalp-record merge part.mcap session.mcap --out both.mcap"};
}

/// The one file of a command.
Result<std::string> file_of(const program::Arguments& arguments, const program::Usage& usage) {
  const std::size_t named = arguments.positional().size();
  if (named == 1) return arguments.positional().front();
  return asked_wrongly("one session file is needed, but " + std::to_string(named) + " are named", usage);
}

/// A command with one file.
template <class Run>
int with_file(const program::Usage& usage, int argc, const char* const* argv, Run run) {
  return program::run_program(usage, argc, argv, [&](const program::Arguments& arguments) {
    const Result<std::string> file = file_of(arguments, usage);
    return file ? run(*file, arguments) : program::fail(file.error(), program::kAskedWrongly);
  });
}

int run_finish(const std::filesystem::path& partial) {
  const Result<RepairReport> report = finish(partial);
  if (!report) return program::fail(report.error());
  for (const std::string& damage : report->damages) program::log(kProgram, partial.string() + ": damage: " + damage);
  program::log(kProgram, in_words(*report));
  return program::kDone;
}

/// The fix for a damaged file. A repair does not mend a message that is not of its topic's type: it copies it
/// unchanged.
std::string mending_of(const SessionFacts& facts, const std::string& file) {
  const auto unreadable = std::ranges::count_if(facts.topics, [](const auto& topic) { return topic.unreadable > 0; });
  if (facts.damages_in_all > static_cast<std::uint64_t>(unreadable)) return "telepalp-record repair " + file;
  return "record again; the other messages can be used, and telepalp-record repair cannot mend the damaged ones";
}

/// The facts of a finished file. Error: also for a recording that was not completed.
Result<SessionFacts> facts_of(const std::string& file) {
  const auto partial = unfinished(file);
  if (!partial) return inspect(file);
  const std::string where_it_is = *partial == file ? "" : ": " + partial->string() + " holds what was written";
  return Error{.what = "the recording was not completed, or is still being made" + where_it_is,
               .where = file,
               .fix = "telepalp-record repair " + file + ", once no recorder writes it any more"};
}

/// A note if an unfinished recording of the same name lies beside `file`.
std::optional<std::string> partial_beside(const std::string& file) {
  std::error_code unknown;
  const std::string partial = file + ".partial";
  if (!std::filesystem::exists(partial, unknown)) return std::nullopt;
  return partial + " lies beside it: a recording of the same name that was not completed";
}

int verify(const std::string& file) {
  const Result<SessionFacts> facts = facts_of(file);
  if (!facts) return program::fail(facts.error());
  const auto print = [&](const char* kind, const std::string& text) {
    std::printf("%s: %s%s\n", program::escaped(file).c_str(), kind, program::escaped(text).c_str());
  };
  if (const auto note = partial_beside(file)) print("note: ", *note);
  for (const std::string& note : notes_on(*facts)) print("note: ", note);
  for (const std::string& damage : facts->damages) print("damage: ", damage);
  if (facts->damages_in_all > 0)
    return program::fail({.what = counted(facts->damages_in_all, "place is damaged", "places are damaged"),
                          .where = file,
                          .fix = mending_of(*facts, file)});
  print("", "whole: " + counted(facts->messages, "message", "messages") + " in " +
                counted(facts->chunks, "chunk", "chunks") + " on " + counted(facts->topics.size(), "topic", "topics") +
                " can be read");
  return program::kDone;
}

int show_edit(const Result<EditReport>& report, const std::string& out) {
  if (!report) return program::fail(report.error());
  for (const std::string& damage : report->damages) program::log(kProgram, "not copied: " + damage);
  std::string text = out + ": " + counted(report->messages, "message", "messages");
  if (report->left_out > 0)
    text += "; left out: " + counted(report->left_out, "message", "messages") + " that another of the files holds, too";
  program::log(kProgram, text);
  return program::kDone;
}

Result<CutOptions> cut_options(const program::Arguments& arguments) {
  const Result<Nanoseconds> from = parse_duration(arguments.text("from"), "from");
  if (!from) return from.error();
  CutOptions options{.from = *from, .to = {}, .topics = TopicFilter(arguments.text("topics"))};
  if (!arguments.has("to")) return options;
  const Result<Nanoseconds> to = parse_duration(arguments.text("to"), "to");
  if (!to) return to.error();
  if (*to <= *from)
    return Error{.what = "the time is not later than that of --from", .where = "--to", .fix = "give a later time"};
  options.to = *to;
  return options;
}

int show_info(const std::string& file, bool json) {
  const Result<SessionFacts> facts = facts_of(file);
  if (!facts) return program::fail(facts.error());
  if (const auto note = partial_beside(file)) program::log(kProgram, "note: " + *note);
  return program::print(json ? in_json(*facts) : in_words(*facts));
}

int run_repair(const std::string& file, const std::string& out) {
  if (const auto partial = unfinished(file); partial && out.empty()) return run_finish(*partial);
  const Result<RepairReport> report = repair(file, out.empty() ? repaired_name(file) : std::filesystem::path(out));
  if (!report) return program::fail(report.error());
  if (report->was_whole) {
    program::log(kProgram, file + " is whole: " + counted(report->messages, "message", "messages") +
                               " can be read; no copy is written");
    if (const auto note = partial_beside(file)) program::log(kProgram, "note: " + *note);
    return program::kDone;
  }
  for (const std::string& damage : report->damages) program::log(kProgram, file + ": damage: " + damage);
  program::log(kProgram, report->file.string() + ": recovered " + recovered(*report));
  return program::kDone;
}

}  // namespace

Error asked_wrongly(std::string what, const program::Usage& usage) {
  return {.what = std::move(what),
          .where = std::string(usage.program),
          .fix = "see " + std::string(usage.program) + " --help"};
}

int info_command(int argc, const char* const* argv) {
  return with_file(info_usage(), argc, argv, [](const std::string& file, const program::Arguments& arguments) {
    return show_info(file, arguments.has("json"));
  });
}

int verify_command(int argc, const char* const* argv) {
  return with_file(verify_usage(), argc, argv,
                   [](const std::string& file, const program::Arguments&) { return verify(file); });
}

int repair_command(int argc, const char* const* argv) {
  return with_file(repair_usage(), argc, argv, [](const std::string& file, const program::Arguments& arguments) {
    return run_repair(file, arguments.text("out"));
  });
}

int cut_command(int argc, const char* const* argv) {
  return with_file(cut_usage(), argc, argv, [](const std::string& file, const program::Arguments& arguments) {
    if (!arguments.has("out"))
      return program::fail(asked_wrongly("the new file is not named: --out FILE.mcap is missing", cut_usage()),
                           program::kAskedWrongly);
    const Result<CutOptions> options = cut_options(arguments);
    if (!options) return program::fail(options.error(), program::kAskedWrongly);
    return show_edit(cut(file, arguments.text("out"), *options), arguments.text("out"));
  });
}

int merge_command(int argc, const char* const* argv) {
  return program::run_program(merge_usage(), argc, argv, [](const program::Arguments& arguments) {
    const std::vector<std::filesystem::path> files(arguments.positional().begin(), arguments.positional().end());
    if (files.size() < 2 || files.size() > kMostMerged || !arguments.has("out"))
      return program::fail(
          asked_wrongly("merge needs 2 to 256 session files, and a new file named by --out", merge_usage()),
          program::kAskedWrongly);
    return show_edit(merge(files, arguments.text("out")), arguments.text("out"));
  });
}

}  // namespace telepalp::record
