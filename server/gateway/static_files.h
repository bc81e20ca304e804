#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::gateway {

/// One file with its HTTP headers.
struct StaticFile {
  std::string content_type;
  std::string etag;  ///< quoted, changes with the bytes
  std::string bytes;
  std::string gzip_etag{};   ///< of `gzip_bytes`: each representation has its own tag (RFC 9110, 8.8.3)
  std::string gzip_bytes{};  ///< `bytes` compressed; empty if gzip saves less than a tenth
  std::string brotli_etag{};
  std::string brotli_bytes{};  ///< of the file NAME.br, which the build made beside NAME; empty: no such file
};

/// Compresses `bytes` to a gzip file (RFC 1952), deterministically.
[[nodiscard]] std::string gzip(const std::string& bytes);

/// The viewer's files, read and compressed once at the start. A request's target is looked up in a table and never used
/// as a path, so no request can reach a file outside the folder.
class StaticFiles {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;  ///< limit for the sum of all files
  static constexpr std::size_t kMaxFiles = 256;

  /// Without files: every request gets "not found".
  StaticFiles() = default;

  /// Reads all regular files of the types of content_type_of() below `folder`; links and hidden files are left out.
  /// NAME.br is the Brotli form of NAME, and is left out when it is older than NAME. Error: no such folder, no
  /// index.html, or over kMaxFiles or kMaxBytes.
  [[nodiscard]] static Result<StaticFiles> read(const std::filesystem::path& folder);

  /// The file for a request target: "/" is index.html, a query is ignored. nullptr when there is no such file.
  [[nodiscard]] const StaticFile* find(std::string_view target) const;

 private:
  std::map<std::string, StaticFile, std::less<>> files_;  // key: "/viewer.js"
};

/// The Content-Type for a file name; empty for types that the viewer does not use.
[[nodiscard]] std::string_view content_type_of(std::string_view file_name) noexcept;

}  // namespace telepalp::gateway
