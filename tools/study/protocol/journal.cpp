#include "tools/study/protocol/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>

#include "codec/bytes/crc32c.h"
#include "proto/words/error_line.h"
#include "proto/words/number_word.h"
#include "proto/words/numbers/number_row.h"
#include "support/program/files/whole_file.h"
#include "tools/study/run/trial_row.h"

namespace telepalp::study {
namespace {

constexpr std::string_view kTitle = "# telepalp-study protocol, form 1: ";
constexpr std::string_view kPerson = "# participant ";
constexpr std::string_view kHand = "; hand: ";
constexpr std::array<std::string_view, 3> kKinds{"training", "formal", "broken-off"};
constexpr std::size_t kSumDigits = 8;

std::string columns() { return "checksum,kind," + std::string(kTrialColumns) + ",held_up_s"; }

std::string checksum(std::string_view row) {
  std::array<char, kSumDigits + 1> text{};
  std::snprintf(text.data(), text.size(), "%08x", codec::crc32c(std::as_bytes(std::span(row))));
  return text.data();
}

Error damaged(const std::string& file, std::size_t line, std::size_t column, std::string what) {
  return {.what = std::move(what),
          .where = file + ":" + std::to_string(line) + ":" + std::to_string(column),
          .fix =
              "restore the file, or delete this line and all lines after it: their penetrations are then asked for "
              "again"};
}

Error no_journal(const std::string& file, std::size_t line) {
  return {.what = "this is no journal of a protocol, or its first lines are damaged",
          .where = file + ":" + std::to_string(line) + ":1",
          .fix = "restore the file, or move it away to begin again"};
}

Result<JournalHead> read_head(std::string_view& text, const std::string& file) {
  JournalHead head;
  std::string_view line = take_line(text);
  if (!line.starts_with(kTitle)) return no_journal(file, 1);
  head.identity = line.substr(kTitle.size());
  line = take_line(text);
  const std::size_t hand = line.find(kHand);
  if (!line.starts_with(kPerson) || hand == std::string_view::npos) return no_journal(file, 2);
  head.participant = line.substr(kPerson.size(), hand - kPerson.size());
  const auto known = std::ranges::find(kHandWords, line.substr(hand + kHand.size()));
  if (known == kHandWords.end()) return no_journal(file, 2);
  head.hand = static_cast<PersonHand>(known - kHandWords.begin());
  if (take_line(text) != columns()) return no_journal(file, 3);
  return head;
}

Result<Attempt> read_line(std::string_view line, const std::string& file, std::size_t number) {
  const std::string_view row = line.size() > kSumDigits ? line.substr(kSumDigits + 1) : std::string_view();
  if (row.empty() || line[kSumDigits] != ',' || checksum(row) != line.substr(0, kSumDigits))
    return damaged(file, number, 1, "the row is damaged: its checksum is another one");
  const std::size_t first = row.find(',');
  const std::size_t last = row.rfind(',');
  const auto kind = std::ranges::find(kKinds, row.substr(0, first));
  if (kind == kKinds.end())
    return damaged(file, number, kSumDigits + 2, "'" + std::string(row.substr(0, first)) + "' is no kind of a row");
  const auto trial = first < last ? read_trial(std::string(row.substr(first + 1, last - first - 1))) : std::nullopt;
  const auto held_up = finite_number_of(row.substr(last + 1));
  if (!trial || !held_up) return damaged(file, number, kSumDigits + first + 3, "the row lacks numbers");
  return Attempt{.kind = static_cast<AttemptKind>(kind - kKinds.begin()), .trial = *trial, .held_up_s = *held_up};
}

Error cannot_write(const std::filesystem::path& file, int code) {
  return {.what = std::string("the row could not be written: ") + std::strerror(code),
          .where = file.string(),
          .fix = "free space on the disk, and give the same command again"};
}

}  // namespace

std::string_view name(AttemptKind kind) noexcept { return kKinds[static_cast<std::size_t>(kind)]; }

std::string journal_begin(const JournalHead& head) {
  return std::string(kTitle) + head.identity + "\n" + std::string(kPerson) + head.participant + std::string(kHand) +
         std::string(words(head.hand)) + "\n" + columns() + "\n";
}

std::string journal_line(const Attempt& attempt) {
  const std::string row =
      std::string(name(attempt.kind)) + "," + trial_row(attempt.trial) + "," + number_text(attempt.held_up_s);
  return checksum(row) + "," + row + "\n";
}

Result<JournalText> parse_journal(std::string_view text, const std::string& file) {
  const std::size_t end = text.rfind('\n');
  const std::size_t whole = end == std::string_view::npos ? 0 : end + 1;
  std::string_view rest = text.substr(0, whole);
  Result<JournalHead> head = read_head(rest, file);
  if (!head) return head.error();
  JournalText read{.head = std::move(*head), .attempts = {}, .whole_bytes = whole};
  for (std::size_t number = 4; !rest.empty(); ++number) {
    Result<Attempt> attempt = read_line(take_line(rest), file, number);
    if (!attempt) return attempt.error();
    read.attempts.push_back(std::move(*attempt));
  }
  return read;
}

Result<std::size_t> done_of(const std::vector<Planned>& plan, const std::vector<Attempt>& attempts,
                            const std::string& file) {
  std::size_t done = 0;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const Trial& trial = attempts[i].trial;
    const bool broken = attempts[i].kind == AttemptKind::BrokenOff;
    const bool planned = done < plan.size() && plan[done].condition == trial.condition &&
                         plan[done].configuration == trial.configuration && plan[done].place == trial.place &&
                         plan[done].penetration == trial.penetration &&
                         (broken || plan[done].training == (attempts[i].kind == AttemptKind::Training));
    if (!planned) return damaged(file, i + 4, 1, "the row is not the penetration that comes next");
    if (!broken) ++done;
  }
  return done;
}

Result<Journal> Journal::open(const std::filesystem::path& file, const JournalHead& head) {
  Journal journal;
  journal.file_ = file;
  if (const auto made = program::make_folder(file.parent_path(), program::Readers::Group); !made) return made.error();
  if (!std::filesystem::exists(file)) {
    if (const auto written = program::write_whole_file(file, journal_begin(head), program::Readers::Group); !written)
      return written.error();
    return journal;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  Result<JournalText> read = parse_journal(text, file.string());
  if (!read) return read.error();
  if (read->head != head)
    return Error{.what = "this journal is of another protocol: " + read->head.identity,
                 .where = file.string(),
                 .fix = "give the options with which it was begun, or another --out"};
  journal.attempts_ = std::move(read->attempts);
  journal.repaired_ = read->whole_bytes < text.size();
  if (journal.repaired_)
    if (const auto written = program::write_whole_file(file, std::string_view(text).substr(0, read->whole_bytes),
                                                       program::Readers::Group);
        !written)
      return written.error();
  return journal;
}

Result<void> Journal::add(const Attempt& attempt) {
  const std::string line = journal_line(attempt);
  const int descriptor = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return cannot_write(file_, errno);
  const ssize_t written = ::write(descriptor, line.data(), line.size());
  const int failed = written == static_cast<ssize_t>(line.size()) && ::fdatasync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (written != static_cast<ssize_t>(line.size()) || failed != 0)
    return cannot_write(file_, failed == 0 ? ENOSPC : failed);
  attempts_.push_back(attempt);
  return {};
}

}  // namespace telepalp::study
