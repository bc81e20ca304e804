#include "tools/replay/commands/run_command.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

#include "haptic_station/core/built_effects.h"
#include "support/program/files/whole_file.h"
#include "tools/replay/commands/report.h"
#include "tools/replay/commands/station_file.h"
#include "tools/replay/storm/invariants.h"
#include "tools/replay/words/say.h"

namespace telepalp::replay {
namespace {

/// The two session files of --out.
struct SessionFiles {
  std::unique_ptr<StationFile> unimpaired;
  std::unique_ptr<StationFile> run;
};

Result<SessionFiles> open_files(const Request& request, const std::filesystem::path& out) {
  if (out.empty()) return SessionFiles{};
  if (const Result<void> made = program::make_folder(out, program::Readers::Group); !made) return made.error();
  Result<std::unique_ptr<StationFile>> unimpaired = StationFile::open(out / "unimpaired.mcap", request);
  if (!unimpaired) return unimpaired.error();
  Result<std::unique_ptr<StationFile>> run = StationFile::open(out / "session.mcap", request);
  if (!run) return run.error();
  return SessionFiles{std::move(*unimpaired), std::move(*run)};
}

Result<void> close_files(const SessionFiles& files) {
  for (StationFile* file : {files.unimpaired.get(), files.run.get()})
    if (file != nullptr)
      if (const Result<void> closed = file->close(); !closed) return closed;
  return {};
}

Publish into(StationFile* file) {
  if (file == nullptr) return {};
  return [file](const wire::Message& message) { file->write(message); };
}

Result<void> write_reports(const std::filesystem::path& out, const std::string& text, const std::string& json) {
  if (out.empty()) return {};
  for (const auto& [name, content] : {std::pair{"report.txt", &text}, {"report.json", &json}})
    if (const Result<void> written = program::write_whole_file(out / name, *content, program::Readers::Group); !written)
      return written;
  return {};
}

/// The folder of the run's files: --out, or a temporary one for a run that is only compared with a baseline.
class OutFolder {
 public:
  static Result<std::unique_ptr<OutFolder>> of(const Request& request) {
    auto folder = std::make_unique<OutFolder>();
    folder->path_ = request.out;
    if (!request.out.empty() || request.baseline.empty()) return folder;
    std::string name = (std::filesystem::temp_directory_path() / "telepalp-replay-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      return Error{.what = "no temporary folder can be made", .where = name, .fix = "give --out DIR"};
    folder->path_ = name;
    folder->is_temporary_ = true;
    return folder;
  }
  OutFolder() = default;
  ~OutFolder() {
    std::error_code ignored;
    if (is_temporary_) std::filesystem::remove_all(path_, ignored);
  }
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  bool is_temporary_ = false;
};

/// Compares the run in `out` with the baseline, prints the outcome, and appends it to `judgements`. The words go to
/// stderr if stdout holds report.json.
Result<void> judge_baseline(const Request& request, const std::filesystem::path& out,
                            std::vector<Judgement>& judgements) {
  if (request.baseline.empty()) return {};
  const Result<report::GateOutcome> outcome =
      report::judge_against(request.baseline, out / "session.mcap", request.tolerances);
  if (!outcome) return outcome.error();
  const std::string words = report::in_words(*outcome);
  std::fputs(words.c_str(), request.json ? stderr : stdout);
  for (const report::Difference& one : outcome->differences)
    judgements.push_back({"from the baseline: " + std::string(one.tolerance.name), one.holds(),
                          one.holds() ? "" : report::in_words(one) + "; likely cause: " + outcome->causes.front()});
  if (!outcome->holds() && outcome->causes.empty())
    judgements.push_back({"from the baseline", false, "nothing could be compared"});
  return program::write_whole_file(out / "baseline.txt", words, program::Readers::Group);
}

/// Passes the run's ticks and messages to the invariants.
void check_with(Invariants& invariants, RunOrder& order) {
  order.publish = [&invariants, publish = order.publish](const wire::Message& message) {
    invariants.add(message);
    if (publish) publish(message);
  };
  order.on_ticks = [&invariants](const std::vector<TickRecord>& ticks) {
    for (const TickRecord& tick : ticks) invariants.add(tick);
  };
}

}  // namespace

std::int64_t steady_ns() noexcept {
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::int64_t thread_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

Result<bool> run_once(const Request& request) {
  Result<Tape> tape = Tape::open(request.source, request.tape);
  if (!tape) return tape.error();
  const Result<std::unique_ptr<OutFolder>> out = OutFolder::of(request);
  if (!out) return out.error();
  const Result<SessionFiles> files = open_files(request, (*out)->path());
  if (!files) return files.error();
  const std::int64_t began_ns = steady_ns();
  const control::ControlSettings& control = request.scene->control;
  Invariants invariants(request.scenario, control,
                        core::bank_of(request.scene->effects).stiffest_N_per_m(control.limits.peak_N));
  RunOrder order{.scenario = request.scenario, .publish = into(files->run.get())};
  if (request.check) check_with(invariants, order);
  const Result<RunResults> results =
      run_session(*tape, request.run_settings(),
                  {{.scenario = unimpaired(request.scenario), .publish = into(files->unimpaired.get())}, order});
  if (!results) return results.error();
  if (const Result<void> closed = close_files(*files); !closed) return closed.error();
  const double wall_s = 1e-9 * static_cast<double>(steady_ns() - began_ns);
  std::vector<Judgement> judgements = judge(request.assertions, results->runs.back().figures);
  const std::string text = report_text(request, *results, judgements);
  const std::string json = report_json(request, request.scenario, request.options, *results, judgements);
  std::fputs((request.json ? json : text).c_str(), stdout);
  std::fflush(stdout);  // where both streams go to one file, the log line below must not cut the text
  say(cost_in_words(*results, wall_s));
  if (const Result<void> written = write_reports((*out)->path(), text, json); !written) return written.error();
  if (const Result<void> compared = judge_baseline(request, (*out)->path(), judgements); !compared)
    return compared.error();
  if (const Result<void> written = write_junit(request, judgements); !written) return written.error();
  if (invariants.violation()) std::printf("FAILS: --check: %s\n", in_words(*invariants.violation()).c_str());
  return !invariants.violation() &&
         std::all_of(judgements.begin(), judgements.end(), [](const Judgement& one) { return one.holds; });
}

}  // namespace telepalp::replay
