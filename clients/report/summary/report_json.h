#pragma once

#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"

namespace telepalp::report {

/// The figures of a run for other programs: docs/report.md names every key. What was not measured is null, never
/// left out.
[[nodiscard]] std::string report_json(const Session& session, const Summary& summary, const Verdict& verdict);

}  // namespace telepalp::report
