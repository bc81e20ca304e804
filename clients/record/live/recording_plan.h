#pragma once

#include <string>

#include "clients/record/live/recording.h"
#include "clients/record/live/session_files.h"

namespace telepalp::record {

/// The plan of a recording, made before it begins: file name, server, recording person, consent and attachments. Error:
/// a file to attach cannot be read or is larger than 16 MiB.
[[nodiscard]] Result<SessionFiles::Plan> plan_of(const RecordingOptions& options);

}  // namespace telepalp::record
