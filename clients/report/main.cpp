#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "clients/record/unfinished.h"
#include "clients/report/compare/comparison_html.h"
#include "clients/report/compare/gate.h"
#include "clients/report/figures/report_html.h"
#include "clients/report/figures/view.h"
#include "clients/report/session/session_file.h"
#include "clients/report/summary/report_json.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "support/images/image_file.h"
#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"

using namespace telepalp;

namespace {

program::Usage usage() {
  static const std::string tolerances =
      "of two sessions: exit code 1 if B differs from A by more than a tolerance. LIST is same, or replaces some of " +
      report::default_tolerances_in_words();
  return {
      .program = "telepalp-report",
      .purpose = "writes report.html, report.json and view.png about a session, or comparison.html about two sessions",
      .positional = "SESSION.mcap [OTHER.mcap]",
      .options =
          {{.name = "out", .argument = "DIR", .help = "folder for the files; created if missing", .initial = "."},
           {.name = "path",
            .argument = "NAME",
            .help = "judge the latency by the limits of lan, lte, hostile or satellite",
            .initial = report::kPaths.front().name},
           {.name = "assert", .argument = "LIST", .help = tolerances}},
      .example = "telepalp-report out/session.mcap --out out"};
}

/// A report shows a patient, so only the file's owner and group may read it.
Result<void> write_file(const std::filesystem::path& file, const std::string& bytes) {
  return program::write_whole_file(file, bytes, program::Readers::Group);
}

/// The session file to report on: `asked`, or, if `asked` is a recording that was cut off, the session completed from
/// it.
Result<std::filesystem::path> finished(const std::filesystem::path& asked) {
  const auto partial = record::unfinished(asked);
  if (!partial) return asked;
  const Result<record::RepairReport> report = record::finish(*partial);
  if (!report) return report.error();
  std::cerr << record::in_words(*report) << "\n";
  return report->file;
}

/// The session file of `asked`, a file or a folder that telepalp-replay wrote. Error: a folder without session.mcap; it
/// names the sessions that the folder holds.
Result<std::filesystem::path> session_of(const std::filesystem::path& asked) {
  std::error_code none;
  const std::filesystem::path file = report::session_file(asked);
  if (!std::filesystem::is_directory(asked, none) || std::filesystem::exists(file, none) || record::unfinished(file))
    return file;
  std::string others;
  for (const auto& entry : std::filesystem::directory_iterator(asked, none))
    if (entry.path().extension() == ".mcap") others += (others.empty() ? "" : ", ") + entry.path().filename().string();
  return Error{.what = "the folder holds no session.mcap" + (others.empty() ? "" : ", but " + others),
               .where = asked.string(),
               .fix = "name a session file, or a folder that telepalp-replay --out wrote"};
}

bool is_encrypted(const std::filesystem::path& session) {
  const auto header = wire::mcap::header_of(session);
  return header && header.value().has_value();
}

Result<void> write_report(const std::filesystem::path& asked, const std::filesystem::path& folder,
                          const report::PathLimits& path) {
  const Result<std::filesystem::path> session_file = session_of(asked);
  if (!session_file) return session_file.error();
  const Result<std::filesystem::path> whole = finished(*session_file);
  if (!whole) return whole.error();
  const std::filesystem::path& file = *whole;
  Result<report::Session> session = report::read_session(file);
  if (!session) return session.error();
  Result<msg::SessionNotes> live = wire::live_notes(file);
  if (!live) return live.error();
  Result<msg::SessionNotes> notes = wire::read_notes(file, std::move(live).value());
  if (!notes) return notes.error();
  session->notes = std::move(*notes);
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made;

  const report::Summary summary = report::summarise(*session);
  const report::Verdict verdict = report::judge(summary, path, &*session);
  const std::int64_t moment_ns = report::deepest_moment_ns(*session);
  const auto frame = report::read_frame(file, *session, moment_ns);
  if (!frame) return frame.error();
  const std::string png = *frame ? images::encode_png(report::draw_view(*session, **frame, moment_ns)) : std::string();

  if (auto done = write_file(folder / "report.json", report::report_json(*session, summary, verdict)); !done)
    return done;
  if (auto done = write_file(folder / "report.html", report::report_html(*session, summary, verdict, png)); !done)
    return done;
  if (!png.empty()) {
    if (auto done = write_file(folder / "view.png", png); !done) return done;
  } else {
    std::cerr << "view.png is not drawn: the session holds no depth image that can be decoded, or no calibration of "
                 "its camera\n";
  }
  if (is_encrypted(file))
    std::cerr << "the session is encrypted, this report of it is not: keep " << folder.string()
              << " on an encrypted disk\n";
  std::cout << verdict.headline << "\n";
  for (std::size_t i = 0; i < verdict.causes.size(); ++i) {
    const report::Cause& cause = verdict.causes[i];
    std::cout << "  " << i + 1 << ". " << cause.what << ".\n"
              << (cause.when.empty() ? "" : "     When: " + cause.when + ".\n") << "     What to do: " << cause.to_do
              << ".\n";
  }
  std::cout << verdict.account << "\n" << (folder / "report.html").string() << "\n";
  return {};
}

/// The picture of `run` at `at_ns` as PNG; empty without images.
Result<std::string> picture(const report::Run& run, std::int64_t at_ns) {
  const auto frame = report::read_frame(run.file, run.session, at_ns);
  if (!frame) return frame.error();
  return *frame ? images::encode_png(report::draw_view(run.session, **frame, at_ns)) : std::string();
}

/// True unless `tolerances` are given and do not hold.
Result<bool> write_comparison(const std::vector<std::string>& asked, const std::filesystem::path& folder,
                              const std::optional<std::vector<report::Tolerance>>& tolerances) {
  const Result<std::filesystem::path> a = finished(asked[0]), b = finished(asked[1]);
  if (!a) return a.error();
  if (!b) return b.error();
  const Result<report::Comparison> comparison = report::compare(*a, *b);
  if (!comparison) return comparison.error();
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made.error();
  const report::Origins origins = report::common_origins(comparison->a.session, comparison->b.session);
  const std::int64_t since_ns = std::llround(1e9 * report::pictured_s(*comparison));
  Result<std::string> first = picture(comparison->a, origins.a_ns + since_ns);
  if (!first) return first.error();
  Result<std::string> second = picture(comparison->b, origins.b_ns + since_ns);
  if (!second) return second.error();
  const std::string page = report::comparison_html(*comparison, {std::move(*first), std::move(*second)});
  if (auto done = write_file(folder / "comparison.html", page); !done) return done.error();
  std::cout << report::headline(*comparison) << "\n"
            << report::account(*comparison) << "\n"
            << (folder / "comparison.html").string() << "\n";
  if (!tolerances) return true;
  const report::GateOutcome outcome = report::judge_against(*comparison, *tolerances);
  std::cout << report::in_words(outcome);
  return outcome.holds();
}

/// The tolerances of --assert; nullopt: the option is not given.
Result<std::optional<std::vector<report::Tolerance>>> read_tolerances(const program::Arguments& given) {
  if (!given.has("assert")) return std::optional<std::vector<report::Tolerance>>();
  Result<std::vector<report::Tolerance>> tolerances = report::parse_tolerances(given.text("assert"), "--assert");
  if (!tolerances) return tolerances.error();
  return std::optional(std::move(*tolerances));
}

int run(const program::Arguments& given) {
  const std::vector<std::string>& sessions = given.positional();
  const std::filesystem::path out = given.text("out");
  if (sessions.size() == 1) {
    const std::optional<report::PathLimits> path = report::path_named(given.text("path"));
    if (!path)
      return program::fail({.what = "'" + given.text("path") + "' is not a network path",
                            .where = "--path",
                            .fix = "give lan, lte, hostile or satellite (docs/report.md)"},
                           program::kAskedWrongly);
    const Result<void> done = write_report(sessions.front(), out, *path);
    return done ? program::kDone : program::fail(done.error());
  }
  const auto tolerances = read_tolerances(given);
  if (!tolerances) return program::fail(tolerances.error(), program::kAskedWrongly);
  const Result<bool> holds = write_comparison(sessions, out, *tolerances);
  // A gate must tell sessions that cannot be compared from sessions that differ.
  if (!holds) return program::fail(holds.error(), *tolerances ? program::kAskedWrongly : program::kFailed);
  return *holds ? program::kDone : program::kFailed;
}

int run_asked(const program::Arguments& arguments) {
  const std::vector<std::string>& sessions = arguments.positional();
  if (sessions.empty() || sessions.size() > 2)
    return program::fail(
        {.what = "one or two session files are needed, but " + std::to_string(sessions.size()) + " are named",
         .where = "telepalp-report",
         .fix = "name one session file to report on, or two to compare: telepalp-report SESSION.mcap [OTHER.mcap]"},
        program::kAskedWrongly);
  if (sessions.size() == 1 && arguments.has("assert"))
    return program::fail({.what = "one session alone cannot be compared",
                          .where = "--assert",
                          .fix = "name the baseline and the run: telepalp-report A B --assert same"},
                         program::kAskedWrongly);
  program::say_when_stopped("telepalp-report: stopped: the report in " + arguments.text("out") +
                            " is not complete; each of its files is whole or as it was before");
  return run(arguments);
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run_asked); }
