#include <cmath>
#include <filesystem>
#include <iostream>

#include "clients/record/unfinished.h"
#include "clients/report/compare/comparison_html.h"
#include "clients/report/figures/report_html.h"
#include "clients/report/figures/view.h"
#include "clients/report/session/session_file.h"
#include "clients/report/summary/report_json.h"
#include "proto/wire/mcap/notes_file.h"
#include "support/images/image_file.h"
#include "support/program/ending.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"

using namespace telepalp;

namespace {

const program::Usage kUsage{
    .program = "telepalp-report",
    .purpose = "writes report.html, report.json and view.png about a session, or comparison.html about two sessions",
    .positional = "SESSION.mcap [OTHER.mcap]",
    .options = {{.name = "out", .argument = "DIR", .help = "folder for the files; created if missing", .initial = "."}},
    .example = "telepalp-report out/session.mcap --out out"};

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

Result<void> write_report(const std::filesystem::path& asked, const std::filesystem::path& folder) {
  const Result<std::filesystem::path> whole = finished(asked);
  if (!whole) return whole.error();
  const std::filesystem::path& file = *whole;
  Result<report::Session> session = report::read_session(file);
  if (!session) return session.error();
  Result<msg::SessionNotes> notes = wire::read_notes(file);
  if (!notes) return notes.error();
  session->notes = std::move(*notes);
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made;

  const report::Summary summary = report::summarise(*session);
  const report::Verdict verdict = report::judge(summary);
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
  std::cout << verdict.headline << "\n" << verdict.account << "\n" << (folder / "report.html").string() << "\n";
  return {};
}

/// The picture of `run` at `at_ns` as PNG; empty without images.
Result<std::string> picture(const report::Run& run, std::int64_t at_ns) {
  const auto frame = report::read_frame(run.file, run.session, at_ns);
  if (!frame) return frame.error();
  return *frame ? images::encode_png(report::draw_view(run.session, **frame, at_ns)) : std::string();
}

Result<void> write_comparison(const std::vector<std::string>& asked, const std::filesystem::path& folder) {
  const Result<std::filesystem::path> a = finished(asked[0]), b = finished(asked[1]);
  if (!a) return a.error();
  if (!b) return b.error();
  const Result<report::Comparison> comparison = report::compare(*a, *b);
  if (!comparison) return comparison.error();
  if (const Result<void> made = program::make_folder(folder, program::Readers::Group); !made) return made;
  const report::Origins origins = report::common_origins(comparison->a.session, comparison->b.session);
  const std::int64_t since_ns = std::llround(1e9 * report::pictured_s(*comparison));
  Result<std::string> first = picture(comparison->a, origins.a_ns + since_ns);
  if (!first) return first.error();
  Result<std::string> second = picture(comparison->b, origins.b_ns + since_ns);
  if (!second) return second.error();
  const std::string page = report::comparison_html(*comparison, {std::move(*first), std::move(*second)});
  if (auto done = write_file(folder / "comparison.html", page); !done) return done;
  std::cout << report::headline(*comparison) << "\n"
            << report::account(*comparison) << "\n"
            << (folder / "comparison.html").string() << "\n";
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = program::read_arguments(kUsage, argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const auto& given = **arguments;
  const std::vector<std::string>& sessions = given.positional();
  if (sessions.empty() || sessions.size() > 2)
    return program::fail(
        {.what = "one or two session files are needed, but " + std::to_string(sessions.size()) + " are named",
         .where = "telepalp-report",
         .fix = "name one session file to report on, or two to compare: telepalp-report SESSION.mcap [OTHER.mcap]"},
        program::kAskedWrongly);
  program::say_when_stopped("telepalp-report: stopped: the report in " + given.text("out") +
                            " is not complete; each of its files is whole or as it was before");
  const Result<void> done = sessions.size() == 1 ? write_report(sessions.front(), given.text("out"))
                                                 : write_comparison(sessions, given.text("out"));
  return done ? program::kDone : program::fail(done.error());
}
