#pragma once

#include <filesystem>
#include <optional>

#include "clients/report/session/session.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::report {

/// Reads a session file without its images. Error: not a session, empty, or truncated; the error tells how to repair
/// the file.
[[nodiscard]] Result<Session> read_session(const std::filesystem::path& file);

/// The depth frame captured nearest to `at_ns`, with the colour nearest to it; nullopt when this depth cannot be
/// decoded, or the session has no depth or no calibration. Missing or damaged colour is left out.
[[nodiscard]] Result<std::optional<RgbdFrame>> read_frame(const std::filesystem::path& file, const Session& session,
                                                          std::int64_t at_ns);

}  // namespace telepalp::report
