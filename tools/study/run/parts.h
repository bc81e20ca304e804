#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::study {

/// A study in parts that do not depend on each other. Each part is a list of rows of text, kept in one file.
struct Parts {
  std::filesystem::path folder;
  std::string identity;      ///< one line that states all on which the rows depend; other files are not used
  std::string_view columns;  ///< names of the rows' columns, separated by commas
  int count = 0;
  std::function<std::string(int)> file;                           ///< name of a part's file
  std::function<bool(const std::vector<std::string>&)> is_whole;  ///< true: the rows read from a file can be used
  std::function<std::vector<std::string>(int)> make;              ///< called from several threads at once
};

/// Number of parts that already have a file of this identity.
[[nodiscard]] int kept_parts(const Parts& parts);

/// Returns the rows of each part, in the order of the parts. Parts whose file can be used are read from it; the others
/// are computed, and each is then written to its file. `finished` is called after each part, from one thread at a time,
/// with the number of parts that are done. Error: a file cannot be written.
[[nodiscard]] Result<std::vector<std::vector<std::string>>> run_parts(const Parts& parts, int threads,
                                                                      const std::function<void(int)>& finished);

/// The rows as a CSV file, under a line that names the study.
[[nodiscard]] std::string rows_text(const std::string& identity, std::string_view columns,
                                    const std::vector<std::string>& rows);

/// "program version commit, seed N": how each study's identity begins.
[[nodiscard]] std::string program_identity(std::uint64_t seed);

}  // namespace telepalp::study
