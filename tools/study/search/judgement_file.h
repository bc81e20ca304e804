#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unordered_map>

#include "tools/study/search/design_search.h"

namespace telepalp::study {

/// evaluations.csv: each judged mechanism in one row, written at once. A row that was cut off is dropped when the file
/// is opened, so a search that was killed resumes.
class JudgementFile final : public JudgementStore {
 public:
  /// Opens or creates out/evaluations.csv. Rows of another program, seed, number of operators or ranges are not used,
  /// and their file is replaced. Error: the file cannot be written.
  [[nodiscard]] static Result<std::unique_ptr<JudgementFile>> open(const std::filesystem::path& out,
                                                                   const SearchSettings& settings);

  [[nodiscard]] std::optional<Judgement> find(bool held_out, const Configuration& mechanism) override;
  void keep(bool held_out, const Configuration& mechanism, const Judgement& judgement) override;

  /// Number of rows that an earlier search left.
  [[nodiscard]] int found() const noexcept { return found_; }
  /// Error: some row could not be written, as on a full disk.
  [[nodiscard]] Result<void> written() const;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  std::unordered_map<std::string, Judgement> rows_;
  std::ofstream out_;
  int found_ = 0;
};

/// All on which a judgement depends besides the mechanism, in one line.
[[nodiscard]] std::string identity_of(const SearchSettings& settings);

}  // namespace telepalp::study
