#include "server/gateway/static_files.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "proto/words/demand.h"

namespace telepalp::gateway {
namespace {

namespace fs = std::filesystem;

struct ContentType {
  std::string_view extension;
  std::string_view type;
};
constexpr std::array kContentTypes{
    ContentType{".html", "text/html; charset=utf-8"},
    ContentType{".js", "text/javascript; charset=utf-8"},
    ContentType{".css", "text/css; charset=utf-8"},
    ContentType{".svg", "image/svg+xml"},
    ContentType{".png", "image/png"},
    ContentType{".wasm", "application/wasm"},
    ContentType{".json", "application/json"},
    ContentType{".txt", "text/plain; charset=utf-8"},
    ContentType{".woff2", "font/woff2"},
};

Error cannot_serve(const fs::path& folder, std::string what) {
  return {
      .what = std::move(what),
      .where = folder.string(),
      .fix = "name by --viewer the folder with the web viewer's index.html, which the target telepalp_viewer builds"};
}

/// FNV-1a, 64 bits. An ETag must only distinguish builds.
std::string etag_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  std::array<char, 19> text{};
  std::snprintf(text.data(), text.size(), "\"%016llx\"", static_cast<unsigned long long>(hash));
  return text.data();
}

/// Compresses `file` unless that saves less than a tenth: images are compressed already.
void add_gzip(StaticFile& file) {
  std::string smaller = gzip(file.bytes);
  if (smaller.size() > file.bytes.size() / 10 * 9) return;
  file.gzip_etag = etag_of(smaller);
  file.gzip_bytes = std::move(smaller);
}

std::string bytes_of(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(bytes).str();
}

/// Adds the Brotli form of the file at `path`, if the build left one beside it. `most_bytes`: a larger one is left out.
void add_brotli(StaticFile& file, const fs::path& path, std::uintmax_t most_bytes) {
  std::error_code failed;
  const fs::path compressed = path.native() + ".br";
  if (!fs::is_regular_file(fs::symlink_status(compressed, failed))) return;
  if (fs::last_write_time(compressed, failed) < fs::last_write_time(path, failed) || failed) return;
  if (fs::file_size(compressed, failed) > most_bytes || failed) return;
  file.brotli_bytes = bytes_of(compressed);
  file.brotli_etag = etag_of(file.brotli_bytes);
}

bool is_hidden(const fs::path& file) { return file.filename().string().starts_with('.'); }

}  // namespace

std::string_view content_type_of(std::string_view file_name) noexcept {
  for (const ContentType& known : kContentTypes)
    if (file_name.ends_with(known.extension)) return known.type;
  return {};
}

std::string gzip(const std::string& bytes) {
  constexpr int kGzipWindow = 15 + 16;  // the largest window; 16 asks for gzip's header and trailer
  constexpr int kMemoryLevel = 8;
  z_stream stream{};
  demand(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel, Z_DEFAULT_STRATEGY) == Z_OK,
         "zlib accepts its settings");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib reads it only
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  demand(deflate(&stream, Z_FINISH) == Z_STREAM_END, "zlib compresses a whole file into its buffer");
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

Result<StaticFiles> StaticFiles::read(const fs::path& folder) {
  std::error_code failed;
  StaticFiles files;
  std::size_t total_bytes = 0;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const fs::path& path = entry->path();
    const std::string_view type = content_type_of(path.native());
    if (is_hidden(path)) entry.disable_recursion_pending();
    if (is_hidden(path) || entry->is_symlink() || !entry->is_regular_file() || type.empty()) continue;
    const std::uintmax_t size = entry->file_size(failed);
    if (failed) break;
    if (size > kMaxBytes - total_bytes || files.files_.size() == kMaxFiles)
      return cannot_serve(folder, "is not a viewer: it holds more than " + std::to_string(kMaxFiles) +
                                      " files, or more than " + std::to_string(kMaxBytes >> 20U) + " MiB");
    StaticFile file{.content_type = std::string(type), .etag = {}, .bytes = bytes_of(path)};
    if (file.bytes.size() != size) return cannot_serve(path, "cannot be read");
    total_bytes += file.bytes.size();
    file.etag = etag_of(file.bytes);
    add_gzip(file);
    add_brotli(file, path, kMaxBytes - total_bytes);
    total_bytes += file.brotli_bytes.size();
    files.files_.emplace("/" + path.lexically_relative(folder).generic_string(), std::move(file));
  }
  if (failed) return cannot_serve(folder, "cannot be read: " + failed.message());
  if (files.find("/") == nullptr) return cannot_serve(folder, "has no index.html");
  return files;
}

const StaticFile* StaticFiles::find(std::string_view target) const {
  target = target.substr(0, target.find_first_of("?#"));
  const auto found = files_.find(target == "/" ? std::string_view("/index.html") : target);
  return found == files_.end() ? nullptr : &found->second;
}

}  // namespace telepalp::gateway
