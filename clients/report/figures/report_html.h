#pragma once

#include <string>

#include "clients/report/session/session.h"
#include "clients/report/summary/summary.h"
#include "clients/report/summary/verdict.h"

namespace telepalp::report {

/// The report for people: one file that needs no script, no network and no other file, and prints well.
/// `view_png`: the augmented view; empty when there is none.
[[nodiscard]] std::string report_html(const Session& session, const Summary& summary, const Verdict& verdict,
                                      const std::string& view_png);

}  // namespace telepalp::report
