#include "tests/bench/hand/hand_bench.h"

#include <unistd.h>

#include <cstdio>

#include "tests/bench/choice.h"
#include "tests/bench/hand/patient.h"
#include "tests/bench/hand/picture.h"
#include "tests/bench/hand/reached.h"
#include "tests/bench/hand/studies.h"

namespace telepalp::bench {
namespace {

using hand::Options;
using hand::Study;

void say_progress(const std::string& study, int done, int of) {
  std::fprintf(stderr, "\r\033[K%s: %d of %d runs%s", study.c_str(), done, of, done == of ? "\r\033[K" : "");
  std::fflush(stderr);
}

std::string names_of(const std::vector<Study>& studies) {
  std::string names;
  for (const Study& study : studies) names += (names.empty() ? "" : ", ") + study.name;
  return names;
}

/// --row picture: draws force.svg instead of measuring.
Result<Report> draw_picture(const program::Arguments& arguments) {
  if (!arguments.has("write"))
    return Error{.what = "no folder is given for the picture",
                 .where = "telepalp-bench hand --row picture",
                 .fix = "add --write DIR; the picture becomes DIR/force.svg"};
  const std::string file = arguments.text("write") + "/force.svg";
  if (const auto drawn = hand::draw_force(file); !drawn) return drawn.error();
  return Report{.bench = "hand", .rows = {}, .notes = {"drawn: " + file}};
}

}  // namespace

namespace hand {

std::vector<Study> all_studies() {
  std::vector<Study> all;
  for (const auto& group : {skin_felt_again(), colleague(),     arm_over(),        limits_of_sight(), step_response(),
                            excess_work(),     rubbing(),       anchor_drift(),    re_entry(),        percussion(),
                            force_error(),     beside_ideal(),  under_half(),      stiffness(),       coughs(),
                            lies_down(),       inner_objects(), creases(),         mesh_slides(),     device_faults(),
                            device_loop(),     browser_hand(),  hand_prediction(), paper_trials(),    cost()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace hand

Result<Report> run_hand(const program::Arguments& arguments) {
  const Result<double> seeds = arguments.number("seeds", 1.0, 100'000.0);
  if (!seeds) return seeds.error();
  if (const auto torso = hand::torso_is_there(); !torso) return torso.error();
  const std::string wanted = arguments.has("row") ? arguments.text("row") : "";
  if (wanted == "picture") return draw_picture(arguments);
  Report report{.bench = "hand", .rows = {}, .notes = {}};
  std::vector<Study> studies = hand::all_studies();
  if (arguments.has("input"))
    for (Study& study : hand::slides_over(arguments.text("input"))) studies.push_back(std::move(study));
  for (const Study& study : studies) {
    if (!contains_one_of(study.name, wanted)) continue;
    Options options{.seeds = static_cast<int>(*seeds)};
    if (isatty(STDERR_FILENO) != 0) options.progress = [&](int done, int of) { say_progress(study.name, done, of); };
    for (Row& row : study.measure(options)) report.rows.push_back(std::move(row));
  }
  if (report.rows.empty())
    return Error{.what = "no study's name contains '" + wanted + "'",
                 .where = "telepalp-bench hand --row",
                 .fix = "give parts of these names, with commas between: " + names_of(studies) +
                        "; or picture, with --write DIR, for a picture of the force over time"};
  if (arguments.has("write"))
    if (const auto written = hand::write_reached(report, arguments.text("write") + "/reached.tsv"); !written)
      return written.error();
  if (arguments.has("reached")) {
    const Result<hand::Reached> reached = hand::read_reached(arguments.text("reached"));
    if (!reached) return reached.error();
    hand::accept_reached(*reached, report);
  }
  report.notes = {
      "virtual time, ticks at 2 kHz, frames at 30 Hz or as named; torso 0.8 m from a Kinect-like camera",
      "skin of 500 N/m, in most studies with both settings of its anchor; of 100 N/m in drift; by the law of paper S1 "
      "in inner, far face and trials",
      "link: round-trip time (RTT) random or as named, 10 % of frames lost in bursts of four, jitter of 30 ms; no link "
      "in step, trials, prediction, cost, and in floor without delay",
      "excess work: work on the hand in a contact, beyond that of the true skin on the same path",
      "force RMSE: against the force law on the true skin; without contact, this law's whole force is the error"};
  return report;
}

}  // namespace telepalp::bench
