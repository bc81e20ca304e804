#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/hand/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench::hand {

/// One experiment and the rows that it fills. `--row PATTERN` picks studies whose name contains PATTERN; the name is
/// the beginning of each of its rows' names.
struct Study {
  std::string name;
  std::function<std::vector<Row>(const Options& options)> measure;
};

[[nodiscard]] std::vector<Study> skin_felt_again();
[[nodiscard]] std::vector<Study> colleague();
[[nodiscard]] std::vector<Study> arm_over();
[[nodiscard]] std::vector<Study> limits_of_sight();
[[nodiscard]] std::vector<Study> step_response();
[[nodiscard]] std::vector<Study> excess_work();
[[nodiscard]] std::vector<Study> anchor_drift();
[[nodiscard]] std::vector<Study> re_entry();
[[nodiscard]] std::vector<Study> percussion();
[[nodiscard]] std::vector<Study> rubbing();
[[nodiscard]] std::vector<Study> force_error();
[[nodiscard]] std::vector<Study> beside_ideal();
[[nodiscard]] std::vector<Study> under_half();
[[nodiscard]] std::vector<Study> stiffness();
[[nodiscard]] std::vector<Study> coughs();
[[nodiscard]] std::vector<Study> lies_down();
[[nodiscard]] std::vector<Study> inner_objects();
[[nodiscard]] std::vector<Study> creases();
[[nodiscard]] std::vector<Study> mesh_slides();
/// A study of slides for each mesh (.ply, .obj) of a folder of the user's, in metres or decimetres.
[[nodiscard]] std::vector<Study> slides_over(const std::filesystem::path& folder);
[[nodiscard]] std::vector<Study> device_faults();
[[nodiscard]] std::vector<Study> browser_hand();
[[nodiscard]] std::vector<Study> device_loop();
[[nodiscard]] std::vector<Study> hand_prediction();
[[nodiscard]] std::vector<Study> paper_trials();
[[nodiscard]] std::vector<Study> cost();

/// All of them, in the order of the report.
[[nodiscard]] std::vector<Study> all_studies();

}  // namespace telepalp::bench::hand
