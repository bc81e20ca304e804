#include <filesystem>
#include <iostream>

#include "clients/record/unfinished.h"
#include "clients/report/figures/report_html.h"
#include "clients/report/figures/view.h"
#include "clients/report/session/session_file.h"
#include "clients/report/summary/report_json.h"
#include "support/images/image_file.h"
#include "support/program/files/whole_file.h"
#include "support/program/options.h"

using namespace telepalp;

namespace {

const program::Usage kUsage{
    .program = "telepalp-report",
    .purpose = "reports on a session file: report.html for people, report.json for programs, view.png",
    .positional = "SESSION.mcap",
    .options =
        {{.name = "out", .argument = "DIR", .help = "folder for the three files; created if missing", .initial = "."}},
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
  const Result<report::Session> session = report::read_session(file);
  if (!session) return session.error();
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
    std::cerr << "view.png: not drawn, the session holds no depth frame with its calibration\n";
  }
  std::cout << verdict.headline << "\n" << verdict.account << "\n" << (folder / "report.html").string() << "\n";
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = program::read_arguments(kUsage, argc, argv);
  if (!arguments) return program::fail(arguments.error(), program::kAskedWrongly);
  if (!*arguments) return program::kDone;
  const auto& given = **arguments;
  if (given.positional().size() != 1)
    return program::fail({.what = "name one session file", .where = "telepalp-report", .fix = "telepalp-report --help"},
                         program::kAskedWrongly);
  const Result<void> done = write_report(given.positional().front(), given.text("out"));
  return done ? program::kDone : program::fail(done.error());
}
