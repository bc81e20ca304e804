#include "clients/record/unfinished.h"

#include <cerrno>
#include <cstring>

#include "clients/record/recorder_lock.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "proto/words/counted.h"

namespace telepalp::record {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCannotBeFinished = "the recording cannot be completed";

fs::path finished_name(const fs::path& partial) {
  const std::string name = partial.string();
  return name.substr(0, name.size() - kPartial.size());
}

/// True if the partial file holds nothing that the finished one lacks.
bool holds_nothing_more(const RepairReport& report) {
  return report.only_end_is_missing || (report.damages.empty() && report.lost == 0U);
}

}  // namespace

std::optional<fs::path> unfinished(const fs::path& asked) {
  std::error_code ignored;
  if (asked.string().ends_with(kPartial) && fs::is_regular_file(asked, ignored)) return asked;
  const fs::path partial = asked.string() + std::string(kPartial);
  if (fs::exists(asked, ignored) || !fs::is_regular_file(partial, ignored)) return std::nullopt;
  return partial;
}

Result<RepairReport> finish(const fs::path& partial) {
  const fs::path name = finished_name(partial);
  std::error_code ignored;
  if (fs::exists(name, ignored))
    return Error{
        .what = std::string(kCannotBeFinished) + ": " + name.filename().string() + " exists already",
        .where = partial.string(),
        .fix =
            "move one of the two files away, or copy the readable messages to another file: telepalp-record repair " +
            partial.string() + " --out OTHER.mcap"};
  const Result<RecorderLock> lock = RecorderLock::take(partial, kCannotBeFinished);
  if (!lock) return lock.error();
  const fs::path made =
      name.string() + ".finishing";  // under the lock, so a file with this name is the rest of a crash
  fs::remove(made, ignored);
  fs::remove(made.string() + std::string(kPartial), ignored);
  Result<RepairReport> report = repair(partial, made);
  if (!report) return report;
  if (wire::mcap::rename_without_replacing(report->file, name) != 0)
    return Error{.what = std::string(kCannotBeFinished) + ": " + std::strerror(errno),
                 .where = name.string(),
                 .fix = "check the folder and your permissions"};
  report->file = name;
  if (holds_nothing_more(*report)) fs::remove(partial, ignored);
  return report;
}

std::string in_words(const RepairReport& finished) {
  std::string text = finished.file.string() + " was not completed by its recorder; the file is complete now, with " +
                     counted(finished.messages, "message", "messages");
  if (!holds_nothing_more(finished))
    text += "; " + counted(finished.damages.size(), "place was", "places were") +
            " damaged, so the recorder's own file is kept, too: " + finished.file.string() + std::string(kPartial);
  return text;
}

}  // namespace telepalp::record
