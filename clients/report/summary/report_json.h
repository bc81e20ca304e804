#pragma once

#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"

namespace telepalp::report {

/// The results of a run as JSON, for other programs; docs/report.md lists all keys. A value that was not measured is
/// null; no key is omitted.
[[nodiscard]] std::string report_json(const Session& session, const Summary& summary, const Verdict& verdict);

}  // namespace telepalp::report
