#pragma once

#include <filesystem>
#include <string>

#include "clients/report/session/session_file.h"
#include "tests/clients/report/made_session.h"

namespace telepalp::report {

[[nodiscard]] Session session_of(const MadeSession& made);

/// Writes the made session to a file of this name in the test's temporary folder, in place of an older one.
[[nodiscard]] std::filesystem::path written(const MadeSession& made, const std::string& name);

[[nodiscard]] std::string json_of(const Session& session);
[[nodiscard]] std::string html_of(const Session& session);

}  // namespace telepalp::report
