#pragma once

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// Looks at all that a server with these options needs: ports, keys and their dates, source, files, disks, clock, other
/// servers. Changes nothing and shows no patient.
[[nodiscard]] Findings self_check(const Asked& asked, keys::WallTime now);

}  // namespace telepalp::server
