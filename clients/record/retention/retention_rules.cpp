#include "clients/record/retention/retention_rules.h"

#include <boost/algorithm/string/trim.hpp>
#include <cctype>
#include <charconv>
#include <regex>
#include <sstream>

#include "proto/words/counted.h"
#include "proto/words/numbers/utc_text.h"

namespace telepalp::record {
namespace {

using std::chrono::days;

constexpr const char* kDate = "%Y-%m-%d";
constexpr WallTime kEarliest = std::chrono::sys_days(std::chrono::year{2015} / 1 / 1);

bool is_word_letter(std::string_view text, std::size_t place) {
  return place < text.size() && (std::isalnum(static_cast<unsigned char>(text[place])) != 0 ||
                                 static_cast<unsigned char>(text[place]) >= 0x80);
}

int number_in(const std::string& digits) {
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// Error: the session's date cannot be right, so the clock of its server was wrong.
Result<void> check_date(const RecordedSession& session, WallTime now) {
  if (session.began >= kEarliest && session.began <= now + days(1)) return {};
  return Error{.what = "its date, " + utc_text(session.began, kDate) + ", cannot be right, so its age is not known",
               .where = session.file,
               .fix =
                   "set the clocks of the server and of this computer; delete the file by hand, or name it in the list "
                   "of --withdrawn"};
}

}  // namespace

std::vector<std::string> withdrawn_in(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream all{std::string(text)};
  for (std::string line; std::getline(all, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    boost::algorithm::trim(line);
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

bool names(std::string_view line, const RecordedSession& session) {
  if (line == session.file) return true;
  const std::string_view consent = session.consent;
  for (std::size_t place = consent.find(line); place != std::string_view::npos; place = consent.find(line, place + 1))
    if ((place == 0 || !is_word_letter(consent, place - 1)) && !is_word_letter(consent, place + line.size()))
      return true;
  return false;
}

Result<std::optional<WallTime>> end_of_consent(std::string_view consent) {
  static const std::regex kUntil("\\b[Uu]ntil ([0-9]{4})-([0-9]{2})-([0-9]{2})\\b");
  const std::string text(consent);
  std::smatch found;
  if (!std::regex_search(text, found, kUntil)) return std::optional<WallTime>{};
  const std::chrono::year_month_day date{std::chrono::year(number_in(found[1])),
                                         std::chrono::month(static_cast<unsigned>(number_in(found[2]))),
                                         std::chrono::day(static_cast<unsigned>(number_in(found[3])))};
  if (date.ok()) return std::optional<WallTime>(std::chrono::sys_days(date) + days(1));
  return Error{.what = "its consent ends on " + found[0].str().substr(6) + ", which is not a date",
               .where = {},
               .fix = "name the session in the list of --withdrawn if it is to be deleted"};
}

Result<Judgement> judge(const RecordedSession& session, const RetentionRules& rules, WallTime now) {
  for (const std::string& line : rules.withdrawn)
    if (names(line, session)) return Judgement{true, "its consent was withdrawn: " + line};
  Result<std::optional<WallTime>> consent = end_of_consent(session.consent);
  if (!consent) return Error{consent.error().what, session.file, consent.error().fix};
  if (const Result<void> dated = check_date(session, now); !dated) return dated.error();
  std::optional<WallTime> end = *consent;
  std::string reason = end ? "until " + utc_text(*end - days(1), kDate) + " by its consent" : "no rule ends it";
  if (rules.keep && (!end || session.began + *rules.keep < *end)) {
    end = session.began + *rules.keep;
    reason = "until " + utc_text(*end, kDate) + ", " +
             counted(static_cast<std::uint64_t>(rules.keep->count()), "day", "days") + " from its beginning";
  }
  return Judgement{end && now >= *end, reason};
}

}  // namespace telepalp::record
