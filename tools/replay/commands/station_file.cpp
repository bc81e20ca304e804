#include "tools/replay/commands/station_file.h"

#include "support/program/version.h"

namespace telepalp::replay {
Result<std::unique_ptr<StationFile>> StationFile::open(const std::filesystem::path& file, const Request& request) {
  Result<wire::McapWriter> writer = wire::McapWriter::open(file, {.program = "telepalp-replay",
                                                                  .version = program::version(),
                                                                  .commit = program::commit(),
                                                                  .source = request.source,
                                                                  .scene = request.scene_text});
  if (!writer) return writer.error();
  return std::unique_ptr<StationFile>(new StationFile(std::move(*writer)));
}

void StationFile::write(const wire::Message& message) {
  if (failed_) return;
  if (const Result<void> written = writer_.write(message); !written) failed_ = written.error();
}

Result<void> StationFile::close() {
  const Result<void> closed = writer_.close();
  if (failed_) return *failed_;
  return closed;
}

}  // namespace telepalp::replay
