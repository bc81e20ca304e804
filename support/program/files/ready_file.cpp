#include "support/program/files/ready_file.h"

#include "support/program/files/whole_file.h"

namespace telepalp::program {

Result<void> write_ready_file(const std::filesystem::path& file, const std::string& text) {
  if (file.empty()) return {};
  return write_whole_file(file, text, Readers::Anyone);
}

}  // namespace telepalp::program
