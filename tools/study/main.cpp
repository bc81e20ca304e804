// telepalp-study: simulated people in the studies of the papers. Without a command, operators try a design's mechanisms
// on layered tissue, as paper S4's subjects did.

#include "support/program/files/whole_file.h"
#include "tools/study/commands.h"
#include "tools/study/designer_command.h"
#include "tools/study/page/files.h"
#include "tools/study/progress.h"
#include "tools/study/protocol_command.h"

namespace {

using namespace telepalp;
using namespace telepalp::study;

const program::Usage kStudyUsage{
    .program = "telepalp-study",
    .purpose =
        "simulated people in the studies of the papers. Without a command: operators puncture a sac with each "
        "mechanism of a design; the study tells how far the needle overshoots",
    .positional = "",
    .options =
        {
            kDesignOption,
            {"operators", "N", "number of simulated operators, each with an own body and tissue", "12"},
            {"penetrations", "N", "of each mechanism by each operator in each condition", "5"},
            kSeedOption,
            kThreadsOption,
            {"out", "DIR", kOutHelp},
            kJsonOption,
        },
    .example = "telepalp-study --operators 2 --penetrations 2 --out study",
    .commands = {{"designer", "", "a page in which a mechanism is turned, changed and compared", run_designer},
                 {"protocol", "", "a person follows the protocol of the operators, in a browser", run_protocol},
                 {"search", "", "the mechanism that overshoots least, for each bound on the hand's force", run_search},
                 {"obstruction", "", "a ball is pushed with the device in sight or hidden (S3 8.3)", run_obstruction},
                 {"stiffness-jnd", "", "the least difference in stiffness that is told (S3 8.4)", run_stiffness_jnd},
                 {"rib-count", "", "ribs are counted by touch and by sight (S2's scene)", run_rib_count}},
};

Result<StudySettings> read_study_settings(const program::Arguments& arguments) {
  StudySettings settings;
  Result<Design> read = read_design_choice(arguments);
  if (!read) return read.error();
  settings.design = std::move(*read);
  const Result<std::int64_t> operators = arguments.whole("operators", 1, 200);
  if (!operators) return operators.error();
  const Result<std::int64_t> penetrations = arguments.whole("penetrations", 1, 50);
  if (!penetrations) return penetrations.error();
  const Result<RunChoice> choice = read_run_choice(arguments);
  if (!choice) return choice.error();
  settings.operators = static_cast<int>(*operators);
  settings.penetrations = static_cast<int>(*penetrations);
  settings.seed = choice->seed;
  settings.threads = choice->threads;
  settings.out = choice->out;
  return settings;
}

Result<StudyResult> run(const StudySettings& settings) {
  const std::function<void(int)> finished = tell_progress(parts_of(settings));
  const Result<Check> check = check_operators(settings);
  if (!check) return check.error();
  const Result<std::vector<Trial>> trials = run_study(settings, finished);
  if (!trials) return trials.error();
  const auto write = [&](const char* file, const std::string& text) {
    return program::write_whole_file(settings.out / file, text, program::Readers::Anyone);
  };
  if (const auto written = write("trials.csv", trials_csv(settings, *trials)); !written) return written.error();
  const Result<StudyResult> result = result_of(settings, *trials, *check);
  if (!result) return result.error();
  if (const auto written = write("study.json", result_json(settings, *result)); !written) return written.error();
  if (const auto written = write("report.html", result_html(settings, *result)); !written) return written.error();
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  return program::run_program(kStudyUsage, argc, argv, [](const program::Arguments& arguments) {
    const Result<StudySettings> settings = read_study_settings(arguments);
    if (!settings) return program::fail(settings.error(), program::kAskedWrongly);
    const Result<StudyResult> result = run(*settings);
    if (!result) return program::fail(result.error());
    return program::print(arguments.has("json") ? result_json(*settings, *result) : result_text(*settings, *result));
  });
}
