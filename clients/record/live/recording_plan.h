#pragma once

#include <string>

#include "clients/record/live/recording.h"
#include "clients/record/live/session_files.h"

namespace telepalp::record {

/// The plan of a recording, made before it begins: names, origin, consent and attachments. Error: a file to attach
/// cannot be read.
[[nodiscard]] Result<SessionFiles::Plan> plan_of(const RecordingOptions& options);

}  // namespace telepalp::record
