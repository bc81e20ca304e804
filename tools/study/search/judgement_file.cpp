#include "tools/study/search/judgement_file.h"

#include <iterator>
#include <vector>

#include "codec/bytes/crc32c.h"
#include "proto/words/error_line.h"
#include "proto/words/number_word.h"
#include "proto/words/numbers/number_row.h"
#include "support/program/files/whole_file.h"
#include "tools/study/run/parts.h"

namespace telepalp::study {
namespace {

// After `operators` and the nine parameters of the mechanism, which are the key of a row.
constexpr std::string_view kColumns =
    "judged_by,l1_m,l2_m,l3_m,l4_m,theta_rad,phi_rad,h_m,l_h_m,needle_m,failed,never,noticed_share,"
    "overshoot_mm,hand_N,overshoots_mm,hands_N,refused";
constexpr std::size_t kKeyCells = 10;
constexpr std::size_t kCells = 18;

std::string key_of(bool held_out, const Configuration& mechanism) {
  std::string key = held_out ? "held-out" : "search";
  for (const MechanismParameter& one : mechanism_parameters()) {
    const bool drawn = (one.name == "l4" && !mechanism.l4_given) || (one.name == "needle" && !mechanism.needle_given);
    key += "," + (drawn ? "drawn" : number_text(mechanism.bar.*one.value));
  }
  return key;
}

std::string list_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + number_text(value);
  return text;
}

std::string row_of(const std::string& key, const Judgement& judgement) {
  std::string refused = judgement.refused;
  for (char& letter : refused)
    if (letter == ',' || letter == '\n' || letter == '"') letter = ';';
  const bool judged = judgement.refused.empty();
  return key + "," + std::to_string(judgement.failed) + "," + std::to_string(judgement.never) + "," +
         number_text(judgement.noticed_share) + "," + (judged ? number_text(judgement.overshoot_mm.mean) : "") + "," +
         (judged ? number_text(judgement.hand_N.mean) : "") + "," + list_text(judgement.overshoots_mm) + "," +
         list_text(judgement.hands_N) + "," + refused;
}

template <class Number>
bool read(std::string_view text, Number& out) {
  const std::optional<Number> number = number_of<Number>(text);
  out = number.value_or(Number{});
  return number.has_value();
}

bool read_list(std::string_view text, std::vector<double>& out) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.size(), text.find(' '));
    if (!read(text.substr(0, end), out.emplace_back())) return false;
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return true;
}

struct KeptRow {
  std::string key;
  Judgement judgement;
};

/// nullopt: the row is cut off or damaged.
std::optional<KeptRow> read_row(std::string_view row) {
  std::vector<std::string_view> cells;
  std::size_t key_size = 0;
  for (std::size_t from = 0; cells.size() < kCells + 1;) {
    const std::size_t end = std::min(row.size(), row.find(',', from));
    cells.push_back(row.substr(from, end - from));
    if (cells.size() == kKeyCells) key_size = end;
    if (end == row.size()) break;
    from = end + 1;
  }
  if (cells.size() != kCells) return std::nullopt;
  KeptRow kept{std::string(row.substr(0, key_size)), {}};
  Judgement& judgement = kept.judgement;
  judgement.refused = cells[kCells - 1];
  const bool whole = read(cells[10], judgement.failed) && read(cells[11], judgement.never) &&
                     read(cells[12], judgement.noticed_share) && read_list(cells[15], judgement.overshoots_mm) &&
                     read_list(cells[16], judgement.hands_N) &&
                     judgement.overshoots_mm.size() == judgement.hands_N.size() &&
                     judgement.overshoots_mm.empty() != judgement.refused.empty();
  if (!whole) return std::nullopt;
  summarise(judgement);
  return kept;
}

}  // namespace

std::string identity_of(const SearchSettings& settings) {
  const std::string ranges = ranges_text(operator_ranges()) + ranges_text(plant_ranges());
  return program_identity(settings.seed) + ", " + std::to_string(settings.operators) + " operators, " +
         std::to_string(settings.held_out) + " held out, " + std::to_string(settings.penetrations) +
         " penetrations, ranges " + std::to_string(codec::crc32c(std::as_bytes(std::span(ranges))));
}

Result<std::unique_ptr<JudgementFile>> JudgementFile::open(const std::filesystem::path& out,
                                                           const SearchSettings& settings) {
  if (const Result<void> made = program::make_folder(out, program::Readers::Anyone); !made) return made.error();
  auto file = std::make_unique<JudgementFile>();
  file->path_ = out / "evaluations.csv";
  std::string whole = "# " + identity_of(settings) + "\n" + std::string(kColumns) + "\n";
  std::ifstream in(file->path_, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.starts_with(whole)) {
    std::string_view rest = std::string_view(text).substr(whole.size());
    while (rest.find('\n') != std::string_view::npos) {
      const std::string_view line = take_line(rest);
      std::optional<KeptRow> row = read_row(line);
      if (!row || !file->rows_.emplace(row->key, std::move(row->judgement)).second) continue;
      whole += std::string(line) + "\n";
      ++file->found_;
    }
  }
  if (const auto written = program::write_whole_file(file->path_, whole, program::Readers::Anyone); !written)
    return written.error();
  file->out_.open(file->path_, std::ios::binary | std::ios::app);
  return file;
}

std::optional<Judgement> JudgementFile::find(bool held_out, const Configuration& mechanism) {
  const auto row = rows_.find(key_of(held_out, mechanism));
  return row == rows_.end() ? std::nullopt : std::optional(row->second);
}

void JudgementFile::keep(bool held_out, const Configuration& mechanism, const Judgement& judgement) {
  const std::string key = key_of(held_out, mechanism);
  out_ << row_of(key, judgement) << '\n' << std::flush;
  rows_.emplace(key, judgement);
}

Result<void> JudgementFile::written() const {
  if (out_) return {};
  return Error{.what = "a row could not be written",
               .where = path_.string(),
               .fix = "free space on the disk, and give the same command again"};
}

}  // namespace telepalp::study
