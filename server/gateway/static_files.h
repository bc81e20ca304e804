#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::server {

/// One file as it is served.
struct StaticFile {
  std::string content_type;
  std::string etag;  ///< quoted, changes with the bytes
  std::string bytes;
  std::string gzip_etag{};  ///< of `gzip_bytes`: the two forms of a file differ, so their tags do too (RFC 9110, 8.8.3)
  std::string gzip_bytes{};  ///< `bytes` compressed; empty for a file that gzip does not make smaller
};

/// `bytes` as a gzip file (RFC 1952) of the same bytes in every run.
[[nodiscard]] std::string gzip(const std::string& bytes);

/// The viewer's files, read and compressed once at start. A request is looked up by name and never turned into a path,
/// so nothing outside the folder can be asked for, whatever the request says.
class StaticFiles {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;  ///< of all files together
  static constexpr std::size_t kMaxFiles = 256;

  /// No files: every request is answered "not found".
  StaticFiles() = default;

  /// Reads all regular files below `folder` whose type is known; links and hidden files are left out.
  /// An error when there is no such folder, no index.html, or too much in it.
  [[nodiscard]] static Result<StaticFiles> read(const std::filesystem::path& folder);

  /// The file for a request target: "/" is index.html, a query is ignored. nullptr when there is none.
  [[nodiscard]] const StaticFile* find(std::string_view target) const;

 private:
  std::map<std::string, StaticFile, std::less<>> files_;  // key: "/viewer.js"
};

/// The Content-Type for a file's name, empty when the type is not one that a viewer consists of.
[[nodiscard]] std::string_view content_type_of(std::string_view file_name) noexcept;

}  // namespace telepalp::server
