#pragma once

#include <memory>
#include <optional>

#include "proto/wire/mcap/writer.h"
#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// A session file with the messages of a replayed station. The same run gives the same bytes.
class StationFile {
 public:
  [[nodiscard]] static Result<std::unique_ptr<StationFile>> open(const std::filesystem::path& file,
                                                                 const Request& request);
  /// Writes a message. After an error, later messages are ignored and close() returns the error.
  void write(const wire::Message& message);
  [[nodiscard]] Result<void> close();

 private:
  explicit StationFile(wire::McapWriter writer) : writer_(std::move(writer)) {}
  wire::McapWriter writer_;
  std::optional<Error> failed_;
};

}  // namespace telepalp::replay
