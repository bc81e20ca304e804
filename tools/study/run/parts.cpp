#include "tools/study/run/parts.h"

#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>

#include "proto/words/numbers/number_row.h"
#include "support/program/files/whole_file.h"
#include "support/program/parallel.h"
#include "support/program/version.h"

namespace telepalp::study {
namespace {

constexpr std::string_view kEnd = "# end";

/// nullopt: the text is cut off, or is of another study.
std::optional<std::vector<std::string>> rows_in(const Parts& parts, std::string_view text) {
  if (take_line(text) != "# " + parts.identity || take_line(text) != parts.columns) return std::nullopt;
  std::vector<std::string> rows;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line == kEnd) return parts.is_whole(rows) ? std::optional(std::move(rows)) : std::nullopt;
    rows.emplace_back(line);
  }
  return std::nullopt;
}

std::optional<std::vector<std::string>> finished_part(const Parts& parts, int part) {
  std::ifstream in(parts.folder / parts.file(part), std::ios::binary);
  if (!in) return std::nullopt;
  return rows_in(parts, std::string(std::istreambuf_iterator<char>(in), {}));
}

}  // namespace

int kept_parts(const Parts& parts) {
  int kept = 0;
  for (int i = 0; i < parts.count; ++i) kept += finished_part(parts, i) ? 1 : 0;
  return kept;
}

Result<std::vector<std::vector<std::string>>> run_parts(const Parts& parts, int threads,
                                                        const std::function<void(int)>& finished) {
  if (const Result<void> made = program::make_folder(parts.folder, program::Readers::Anyone); !made)
    return made.error();
  std::vector<std::vector<std::string>> all(static_cast<std::size_t>(parts.count));
  std::mutex one_at_a_time;
  int done = 0;
  std::optional<Error> failed;
  program::for_each_parallel(parts.count, threads, [&](int i) {
    std::optional<std::vector<std::string>> rows = finished_part(parts, i);
    Result<void> written;
    if (!rows) {
      rows = parts.make(i);
      written = program::write_whole_file(parts.folder / parts.file(i), rows_text(parts.identity, parts.columns, *rows),
                                          program::Readers::Anyone);
    }
    all[static_cast<std::size_t>(i)] = std::move(*rows);
    const std::lock_guard lock(one_at_a_time);
    if (!written) failed = written.error();
    finished(++done);
  });
  if (failed) return *failed;
  return all;
}

std::string rows_text(const std::string& identity, std::string_view columns, const std::vector<std::string>& rows) {
  std::string text = "# " + identity + "\n" + std::string(columns) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  return text + std::string(kEnd) + "\n";
}

std::string program_identity(std::uint64_t seed) {
  return "telepalp-study " + std::string(program::version()) + " " + std::string(program::commit()) + ", seed " +
         std::to_string(seed);
}

}  // namespace telepalp::study
