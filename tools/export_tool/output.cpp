#include "tools/export_tool/output.h"

#include "support/program/files/whole_file.h"

namespace telepalp::export_tool {

int put(const program::Arguments& asked, const std::string& bytes) {
  if (!asked.has("out")) return program::print(bytes);
  const Result<void> written = program::write_whole_file(asked.text("out"), bytes, program::Readers::Group);
  return written ? program::kDone : program::fail(written.error());
}

}  // namespace telepalp::export_tool
