#pragma once

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// What a doctor, a technician and a QA engineer meet: the programs and the page, driven as a user drives them, and
/// wrong in the ways in which users and networks are wrong.
[[nodiscard]] Result<Report> run_users(const program::Arguments& arguments);

}  // namespace telepalp::bench
