#include "clients/record/live/attached_files.h"

#include <chrono>
#include <fstream>
#include <iterator>

namespace telepalp::record {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

std::string media_type(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".html") return "text/html";
  if (extension == ".json") return "application/json";
  if (extension == ".textproto" || extension == ".txt" || extension == ".md") return "text/plain";
  return "application/octet-stream";
}

}  // namespace

Result<wire::mcap::Attachment> attach(const std::filesystem::path& file) {
  const auto unreadable = [&file](const std::string& why) {
    return Error{.what = "cannot be attached to the session: " + why,
                 .where = file.string(),
                 .fix = "check the path and your permissions"};
  };
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return unreadable(code.message());
  if (size > kMostBytes)
    return Error{.what = "is larger than 16 MiB, the limit of an attachment",
                 .where = file.string(),
                 .fix = "do not attach the file; keep it beside the session file"};
  std::ifstream stream(file, std::ios::binary);
  std::string data{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) return unreadable("the file cannot be opened");
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto now_ns = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
  return wire::mcap::Attachment{.log_time = now_ns,
                                .create_time = now_ns,
                                .name = file.filename().string(),
                                .media_type = media_type(file),
                                .data = std::move(data)};
}

}  // namespace telepalp::record
