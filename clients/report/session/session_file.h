#pragma once

#include <filesystem>
#include <optional>

#include "clients/report/session/session.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::report {

/// Reads a whole session file, but for its pictures. A file that is no session, is empty or was cut off is an error
/// that says how to mend it.
[[nodiscard]] Result<Session> read_session(const std::filesystem::path& file);

/// The depth frame captured nearest to `at_ns`, with the colour nearest to it; nullopt when the session has no depth
/// or no calibration. Colour that is missing or damaged is left out.
[[nodiscard]] Result<std::optional<RgbdFrame>> read_frame(const std::filesystem::path& file, const Session& session,
                                                          std::int64_t at_ns);

}  // namespace telepalp::report
