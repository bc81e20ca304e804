#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "proto/keys/revocations.h"
#include "proto/words/result.h"

namespace telepalp::access {

/// The list of revoked keys in a file. It is empty until read() succeeds, and after a failed read() the last good list
/// holds. An older list (by its number) is never taken after a newer one.
class RevokedFile {
 public:
  RevokedFile() = default;
  /// `authority`: PEM of the certificate that signs the list.
  RevokedFile(std::filesystem::path file, std::string authority);

  /// `known_number`: of the newest list that was read before this start; 0: none. Error: the file is missing or too
  /// large, or the list is damaged, of another authority, or older than one that is known.
  [[nodiscard]] Result<void> read(std::uint64_t known_number = 0);
  /// The file was written since the last read().
  [[nodiscard]] bool has_changed() const;

  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }
  [[nodiscard]] const keys::Revocations& list() const noexcept { return list_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }  ///< the list in PEM, as it is in the file

 private:
  std::filesystem::path file_;
  std::string authority_;
  keys::Revocations list_;
  std::string text_;
  std::filesystem::file_time_type read_{};
};

}  // namespace telepalp::access
