#include "proto/program/ready_file.h"

#include <fstream>

namespace telepalp::program {

Result<void> write_ready_file(const std::filesystem::path& file, const std::string& text) {
  if (file.empty()) return {};
  const std::filesystem::path unfinished = file.string() + ".part";
  std::ofstream stream(unfinished, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code code;
  if (stream) std::filesystem::rename(unfinished, file, code);
  if (!stream || code)
    return Error{.what = "cannot be written", .where = file.string(), .fix = "check that the folder exists"};
  return {};
}

}  // namespace telepalp::program
