#pragma once

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// Checks what a server with these options needs: keys and their dates, ports, source, other servers, files, disks and
/// the clock. Writes nothing, opens no camera and publishes nothing.
[[nodiscard]] Findings self_check(const Asked& asked, keys::WallTime now);

}  // namespace telepalp::server
