#pragma once

#include "tests/bench/users/section.h"

namespace telepalp::bench {

/// In each library scene, the bill against the processor time of a real station beside a real server: five pairs of
/// stations, with and without the scene's effects and probe, side by side.
[[nodiscard]] Result<std::vector<Row>> run_bill_section(const UsersPlace& place);
/// What a page says of a server that is silent, and of a played session that is moved image by image, in Chromium.
[[nodiscard]] Result<std::vector<Row>> run_page_section(const UsersPlace& place);

/// The share of a page of 1400 x 900 px that no card covers, in each view of a played session. A card that does not
/// fold to one line, or a view without a fold, makes a row miss its budget.
[[nodiscard]] Result<std::vector<Row>> run_layout_section(const UsersPlace& place);

/// Whether verify and repair of telepalp-record say so when a session is damaged.
[[nodiscard]] Result<std::vector<Row>> run_records_section(const UsersPlace& place);

/// Whether `telepalp-station scene mesh` gives the right mesh of solids that are known from geometry, or refuses them.
[[nodiscard]] Result<std::vector<Row>> run_solids_section(const UsersPlace& place);

/// Work of the displayed force on closed paths of a needle, on a device that measures six degrees of freedom and drives
/// three.
[[nodiscard]] Result<std::vector<Row>> run_tool_section(const UsersPlace& place);

/// A pointer that sweeps over the patient without a button: in virtual time, and in a browser.
[[nodiscard]] Result<std::vector<Row>> run_hover_section(const UsersPlace& place);

/// A gate against a baseline: twelve defects, each planted into a session of the real programs or into its replay, and
/// judged by telepalp-replay --baseline or telepalp-report --assert.
[[nodiscard]] Result<std::vector<Row>> run_gate_section(const UsersPlace& place);

/// A station's journal against telepalp-replay: real server and station over sockets, under load, with the settings
/// fast, cloud and paper in turn. TELEPALP_JOURNAL_RUNS (10) and TELEPALP_JOURNAL_SECONDS (60) set the runs' number and
/// length.
[[nodiscard]] Result<std::vector<Row>> run_journal_section(const UsersPlace& place);

}  // namespace telepalp::bench
