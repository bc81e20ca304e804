#pragma once

#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"

namespace telepalp::report {

/// The section of the page about the depth images that the server had for the station: how many were dropped, lost,
/// received and touched, and what carried them. Empty without these counts.
[[nodiscard]] std::string image_counts_section(const Session& session, const Summary& summary);

/// "UDP (encrypted datagrams) for the whole session", or "TCP until 2.1 s, then UDP (encrypted datagrams)". Empty: not
/// known.
[[nodiscard]] std::string carriers_in_words(const Session& session, const Summary& summary);

/// How long other flows shared the station's line, and the least rate that they left to the session. Empty if none
/// shared it.
[[nodiscard]] std::string shared_line_in_words(const SharedLine& line);

}  // namespace telepalp::report
