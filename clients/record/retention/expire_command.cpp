#include <algorithm>
#include <cstdio>
#include <fstream>

#include "clients/record/file_commands.h"
#include "clients/record/retention/expire.h"
#include "proto/words/counted.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/people/account.h"

namespace telepalp::record {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostListBytes = 1 << 20;

program::Usage usage() {
  return {.program = "telepalp-record expire",
          .purpose = "lists the sessions of a folder whose retention has ended; --delete deletes them",
          .positional = "DIR",
          .options = {{"keep-days", "N", "retention of each session; default: no limit"},
                      {"withdrawn", "FILE", "list of withdrawn consents or session files, one per line"},
                      {"delete", "", "delete, with the notes beside them; without it nothing changes"},
                      {"audit", "FILE", "log of deletions; default: deletions.log in DIR"}},
          .example = "telepalp-record expire recordings --keep-days 365"};
}

Result<std::vector<std::string>> withdrawn_list(const std::string& file) {
  std::error_code failed;
  const std::uintmax_t bytes = fs::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in || bytes > kMostListBytes)
    return Error{.what = failed || !in ? "cannot be read" : "is larger than 1 MiB",
                 .where = file,
                 .fix = "name a text file with one withdrawn consent, or the name of one session file, in each line"};
  return withdrawn_in(std::string{std::istreambuf_iterator<char>(in), {}});
}

Result<RetentionRules> rules_of(const program::Arguments& asked) {
  RetentionRules rules;
  if (asked.has("keep-days")) {
    const Result<std::int64_t> days = asked.whole("keep-days", 1, 36500);
    if (!days) return days.error();
    rules.keep = std::chrono::days(*days);
  }
  if (!asked.has("withdrawn")) return rules;
  Result<std::vector<std::string>> lines = withdrawn_list(asked.text("withdrawn"));
  if (!lines) return lines.error();
  rules.withdrawn = std::move(*lines);
  return rules;
}

void print_line(const std::string& what, const FoundSession& session, const std::string& why) {
  std::printf("%s: %s (%.1f MB): %s\n", what.c_str(), program::escaped(session.facts.file).c_str(),
              static_cast<double>(session.bytes) / 1e6, program::escaped(why).c_str());
}

struct Counts {
  std::uint64_t expired = 0;  ///< deleted, or to be deleted
  std::uint64_t kept = 0;
  std::uint64_t failed = 0;  ///< not judged, or not deleted
};

/// Prints a line for each session. Deletes those that have expired if `log` is not null.
Counts go_through(const Survey& found, RetentionLog* log) {
  Counts counts;
  for (const FoundSession& session : found.sessions) {
    if (session.problem) {
      print_line("not judged, so kept", session, to_string(*session.problem));
      ++counts.failed;
    } else if (!session.judgement.expired) {
      print_line(session.facts.consent.empty() ? "keep, states no consent" : "keep", session, session.judgement.reason);
      ++counts.kept;
    } else if (log == nullptr) {
      print_line("would delete", session, session.judgement.reason);
      ++counts.expired;
    } else if (const Result<void> gone = remove(session, *log, program::account()); gone) {
      print_line("deleted", session, session.judgement.reason);
      ++counts.expired;
    } else {
      print_line("not deleted", session, to_string(gone.error()));
      ++counts.failed;
    }
  }
  for (const std::string& line : found.unmatched)
    std::printf("no session here is named by: %s\n", program::escaped(line).c_str());
  return counts;
}

void say_sum(const Counts& counts, const RetentionLog* log) {
  std::string text = counted(counts.expired, "session", "sessions") + (log == nullptr ? " to delete, " : " deleted, ") +
                     std::to_string(counts.kept) + " kept";
  if (counts.failed > 0) text += ", " + std::to_string(counts.failed) + " with a problem";
  if (log == nullptr && counts.expired > 0) text += ". Nothing was deleted: add --delete";
  if (log != nullptr)
    text += ". The log of deletions ends with line " + std::to_string(log->position().lines) + ", hash " +
            log->position().hash + ": keep this elsewhere";
  program::log(kProgram, text);
}

int run(const program::Arguments& asked) {
  if (asked.positional().size() != 1)
    return program::fail(
        {.what = "one folder is needed", .where = "telepalp-record expire", .fix = "name the folder of the recordings"},
        program::kAskedWrongly);
  const Result<RetentionRules> rules = rules_of(asked);
  if (!rules) return program::fail(rules.error(), program::kAskedWrongly);
  const fs::path folder = asked.positional().front();
  const Result<Survey> found = survey(folder, *rules, std::chrono::system_clock::now());
  if (!found) return program::fail(found.error());
  const bool deletes = asked.has("delete") &&
                       std::ranges::any_of(found->sessions, [](const auto& one) { return one.judgement.expired; });
  std::optional<RetentionLog> log;
  if (deletes) {
    Result<RetentionLog> opened =
        RetentionLog::open(asked.has("audit") ? fs::path(asked.text("audit")) : folder / "deletions.log");
    if (!opened) return program::fail(opened.error());
    log.emplace(std::move(*opened));
  }
  const Counts counts = go_through(*found, log ? &*log : nullptr);
  say_sum(counts, log ? &*log : nullptr);
  return counts.failed == 0 ? program::kDone : program::kFailed;
}

}  // namespace

int expire_command(int argc, const char* const* argv) { return program::run_program(usage(), argc, argv, run); }

}  // namespace telepalp::record
