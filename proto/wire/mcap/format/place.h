#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/format/byte_sink.h"
#include "proto/words/result.h"

namespace telepalp::wire::mcap {

/// Where session files are kept beside the disk, such as in a cluster of servers.
struct Place {
  std::string beginning;  ///< of the names of its sessions: "nats://"
  std::function<Result<std::unique_ptr<ByteSource>>(const std::string& name)> open;
  std::function<Result<std::unique_ptr<ByteSink>>(const std::string& name)> create;
};

/// From now on readers and writers of session files look for names with this beginning in `place`, instead of another
/// place with the same beginning. For main(), before the program has a second thread: the list is global, because each
/// program opens sessions in many parts.
void add_place(Place place);

/// The place of a session of this name; null: the disk.
[[nodiscard]] const Place* place_of(const std::filesystem::path& name);

}  // namespace telepalp::wire::mcap
