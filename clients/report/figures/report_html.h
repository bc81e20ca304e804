#pragma once

#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"

namespace telepalp::report {

/// The report as one self-contained HTML file without scripts, for screen and print.
/// `view_png`: the augmented view as PNG; empty: no view.
[[nodiscard]] std::string report_html(const Session& session, const Summary& summary, const Verdict& verdict,
                                      const std::string& view_png);

}  // namespace telepalp::report
