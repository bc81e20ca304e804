#include "clients/report/figures/report_html.h"

#include <cmath>

#include "clients/ar/messages/phases.h"
#include "clients/report/figures/compensation_figures.h"
#include "clients/report/figures/energy_figures.h"
#include "clients/report/figures/events.h"
#include "clients/report/figures/html.h"
#include "clients/report/figures/image_counts.h"
#include "clients/report/figures/motion_figures.h"
#include "clients/report/figures/page_words.h"
#include "clients/report/figures/speech_figures.h"
#include "clients/report/figures/timing_figures.h"
#include "clients/report/summary/provenance.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"
#include "support/plot/svg.h"

namespace telepalp::report {
namespace {

using plot::escaped;
using plot::number;
using plot::readable;

std::string in_pairs(const std::vector<plot::Chart>& charts) {
  std::string out = "<div class=\"pair\">\n";
  for (const plot::Chart& chart : charts) out += "<div>" + plot::to_svg(chart) + "</div>\n";
  return out + "</div>\n";
}

std::string check_card(const Check& check) {
  const Standing standing = check.standing();
  const char* const look = standing == Standing::Misses ? " misses" : standing == Standing::Holds ? "" : " unknown";
  const std::string budget =
      std::string(check.at_most ? "at most " : "at least ") + readable(check.budget) + " " + check.unit;
  const std::string value =
      standing == Standing::NotMeasured ? "not measured" : readable(check.value) + " " + check.unit;
  return "<div class=\"check" + std::string(look) + "\"><div class=\"name\">" + escaped(check.name) +
         "</div><div class=\"value\">" + escaped(value) + "</div><div class=\"budget\">" +
         (standing == Standing::Misses  ? "✗ required: "
          : standing == Standing::Holds ? "✓ required: "
                                        : "required: ") +
         escaped(budget) + "</div></div>\n";
}

std::string fact(const char* name, const std::string& text) {
  return "<div><dt>" + std::string(name) + "</dt><dd>" + (text.empty() ? "not stated" : escaped(text)) +
         "</dd></div>\n";
}

std::string provenance(const Session& session) {
  const Provenance from = provenance_of(session);
  return "<dl class=\"facts\">\n" + fact("date", from.date) + fact("scene", from.scene) + fact("server", from.server) +
         fact("station", from.station) + fact("file written by", from.software) + fact("recorded by", from.recorder) +
         fact("patient's consent", from.consent) + "</dl>\n<p class=\"notice\">" +
         escaped(std::string(kNotAMedicalDevice)) + "</p>\n";
}

/// The causes of a run that is not good, the most important first.
std::string causes_list(const Verdict& verdict) {
  if (verdict.causes.empty()) return "";
  std::string out = "<ol class=\"causes\">\n";
  for (const Cause& cause : verdict.causes)
    out += "<li>" + escaped(cause.what) + (cause.when.empty() ? "" : ".<br><b>When:</b> " + escaped(cause.when)) +
           ".<br><b>What to do:</b> " + escaped(cause.to_do) + ".</li>\n";
  return out + "</ol>\n";
}

std::string first_screen(const Session& session, const Summary& summary, const Verdict& verdict) {
  std::string out = "<h1>telepalp: report of a run</h1>\n<p class=\"from\">" + escaped(session.name) +
                    (source_of(session).empty() ? "" : " · " + escaped(source_of(session))) + " · " +
                    number(summary.seconds, 1) + " s from the first message to the last · " +
                    counted(session.messages, "message", "messages") + "</p>\n" + provenance(session);
  const char* const look = verdict.good ? "" : summary.ticks > 0 ? " look" : " none";
  out += "<div class=\"verdict" + std::string(look) + "\"><div class=\"headline\">" + escaped(verdict.headline) +
         "</div>\n" + causes_list(verdict) + "<p>" + escaped(verdict.account) + "</p>\n";
  if (summary.damaged_messages > 0)
    out += "<p>Left out: " + counted(summary.damaged_messages, "damaged message", "damaged messages") + ".</p>\n";
  out += "<div class=\"checks\">\n";
  for (const Check& check : verdict.checks) out += check_card(check);
  return out + "</div></div>\n";
}

std::string view_section(const Session& session, const std::string& view_png) {
  if (view_png.empty()) return "";
  if (session.states.empty())
    return section("The patient", "What the camera saw. The session has no position of the doctor's hand.",
                   "<img alt=\"the patient\" src=\"data:image/png;base64," + base64(view_png) + "\">\n");
  return section(
      "The augmented view at the deepest touch",
      "What the camera saw, with the doctor's hand drawn at the proxy on the skin; the deeper the hand presses, "
      "the redder it is drawn. In a run without a touch, the picture shows another moment.",
      "<img alt=\"augmented view\" src=\"data:image/png;base64," + base64(view_png) + "\">\n");
}

std::string notes_section(const Session& session) {
  std::vector<std::vector<std::string>> rows;
  for (const msg::SessionNotes::Note& note : session.notes.notes())
    rows.push_back({number(note.at_s(), 2) + " s", note.text(), note.who(), note.written()});
  if (rows.empty()) return "";
  return section("Notes",
                 "What people noted about moments of the session while they watched it. Times count from the "
                 "session's beginning.",
                 table({"time", "note", "writer", "date of writing"}, rows, Cells::Words));
}

std::string states_section(const Summary& summary) {
  double all_s = 0.0;
  for (const Dwell& dwell : summary.dwells) all_s += dwell.seconds;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < ar::kPhases.size(); ++i)
    rows.push_back({std::string(ar::kPhases[i].words), std::string(ar::kPhases[i].mark),
                    std::to_string(summary.dwells[i].entries), number(summary.dwells[i].seconds, 3),
                    all_s > 0.0 ? number(100.0 * summary.dwells[i].seconds / all_s, 1) + " %" : "–"});
  return section(
      "States",
      "How often the controller entered each state, and how long it stayed there. The shares are of the " +
          number(all_s, 1) +
          " s in which the station's control loop ran. The numbers are those of paper S1 (docs/sources.md); "
          "R and F are not in S1.",
      table({"state", "number", "times entered", "time in the state [s]", "share of the loop's time"}, rows));
}

std::string motion_sections(const Session& session, const Summary& summary) {
  if (session.ticks.size() == 0) return "";
  std::string out =
      section("Position by state",
              "Outside the body, the end-effector follows the hand on a plane above the body; in the body, the hand "
              "pushes the end-effector. The end-effector should not jump where the state changes.",
              plot::to_svg(position_by_state(session)));
  out += section(
      "Force against indentation",
      "All ticks in contact. The indentation is measured from the first point of each contact. The area between the "
      "curves of pressing and leaving is energy that the skin took from the hand. Where the force is larger in "
      "leaving than in pressing, the skin gave the hand energy.",
      in_pairs(force_against_indentation(session)));
  const auto cylinder = around_the_cylinder(session);
  out += cylinder.empty()
             ? section("Objects under the skin",
                       "The hand did not reach a simulated object under the skin (states -3 to -1) in this run.", "")
             : section("Objects under the skin",
                       "Path of the end-effector and force while the hand is at a simulated object under "
                       "the skin (states -3 to -1).",
                       in_pairs({cylinder[0], cylinder[1]}) + plot::to_svg(cylinder[2]));
  std::vector<plot::Chart> whole = timeline(session);
  for (plot::Chart& lane : speech_lanes(session)) whole.push_back(std::move(lane));
  if (!session.spoken.empty())
    for (plot::Chart& chart : whole) chart.x.include = plot::Range{0.0, seconds(session)};
  const std::string spoken = speech_words(session);
  return out + section("The whole run",
                       "State, height and force on one time axis. Only the force of contact comes from the patient. "
                       "Outside the body, a drive moves the end-effector; of its force the hand feels only the lift in "
                       "state 1. The drive gave at most " +
                           readable(summary.force_of_drive_max_N) + " N." + (spoken.empty() ? "" : " " + spoken),
                       plot::to_svg(whole));
}

/// The lanes of speech of a session in which no station was.
std::string speech_section(const Session& session) {
  if (session.spoken.empty() || session.ticks.size() > 0) return "";
  return section("What was said", speech_words(session), plot::to_svg(speech_lanes(session)));
}

/// What it means that the skin above an inner object showed no slide; empty if it always did.
std::string smooth_skin_words(const Summary& summary) {
  if (!(summary.object_slide_unseen_share > 0.0)) return "";
  return " For " + number(100.0 * summary.object_slide_unseen_share, 0) +
         " % of the time, the objects inside the body followed the skin only up and down: depth does not show whether "
         "smooth skin, such as a belly's, slides along itself. If the patient moved sideways then, the objects were "
         "felt where they lay before.";
}

std::string energy_sections(const Session& session, const Summary& summary) {
  std::string out;
  if (const std::vector<plot::Chart> ledgers = energy(session); !ledgers.empty())
    out += section(
        "Energy",
        "Each curve begins at 0 at the beginning of a contact. Energy balance of the display: energy taken from the "
        "hand less energy stored, relative to the displayed skin; below 0, the effects created energy. Excess work: "
        "work on the hand beyond the work that the newest measured skin would do; above 0, the displayed skin moved "
        "or lagged. docs/controller.md names the motions that each curve does not count.",
        plot::to_svg(ledgers));
  if (const std::vector<plot::Chart> warm = heat(session); !warm.empty())
    out +=
        section("Heat",
                counted(summary.heat_warnings, "warning", "warnings") +
                    " of warm motors. Warm motors cannot hold a large force. Four seconds before the force must fall, "
                    "the force vibrates and the station warns; then the force falls slowly to what the motors can "
                    "hold.",
                plot::to_svg(warm));
  return out;
}

std::string timing_sections(const Session& session, const Summary& summary) {
  std::string out;
  if (session.ticks.size() > 0)
    out += section(
        "The 2 kHz loop",
        "Number of ticks by the time that they took, and by their lateness. A tick to the right of the line took, or "
        "was late by, more than its period.",
        in_pairs(tick_times(session)));
  std::string way;
  if (!session.surfaces.empty()) way += plot::to_svg(latency_by_stage(summary));
  if (!session.states.empty()) way += plot::to_svg(surface_age(session));
  way += plot::to_svg(frame_rate(session));
  out +=
      section("From the camera to the hand",
              "Latency of each part of a depth image's way, age of the surface that the hand touches, and images per "
              "second. A surface begins as old as its image's latency, and ages until the next surface replaces it.",
              way);
  if (const std::vector<plot::Chart> done = compensation(session); !done.empty())
    out += section(
        "Compensation of delay",
        "The station predicts from the motion of hand and surface where they are now, and changes gradually to a newer "
        "surface. While the uncertainty is larger than the predicted motion, the place of the felt skin is uncertain." +
            smooth_skin_words(summary),
        plot::to_svg(done));
  out += energy_sections(session, summary);
  if (summary.bill.empty()) return out;
  std::vector<std::vector<std::string>> rows;
  for (const msg::EffectCost& cost : summary.bill)
    rows.push_back({cost.name(), readable(cost.mean_us()), readable(cost.max_us()),
                    readable(100.0 * cost.mean_us() / (session.ticks.period_ns * 1e-3)) + " %"});
  return out + section("Computing time of the effects",
                       "Computing time of each effect of the scene in a tick of 500 µs.",
                       table({"effect", "mean [µs]", "max [µs]", "mean, share of the tick's period"}, rows));
}

std::string senders_section(const Summary& summary) {
  if (summary.senders.size() < 2) return "";
  const auto count = [](const std::optional<std::uint64_t>& value) { return value ? std::to_string(*value) : "–"; };
  std::vector<std::vector<std::string>> rows;
  for (const SenderSummary& sender : summary.senders)
    rows.push_back({in_words(sender), std::to_string(sender.messages), std::to_string(sender.ticks),
                    std::to_string(sender.touches), count(sender.frames_sent), count(sender.frames_received),
                    count(sender.frames_dropped)});
  return section(
      "Senders",
      "Programs that published on a station's topics. All other figures on this page are those of the first program, "
      "which has the most ticks. Depth images are counted during the recording: those that the server sent to the "
      "program, those that the program received, and those that the server replaced by a newer image before sending "
      "them (dropped).",
      table({"program", "messages published", "ticks recorded", "contacts", "depth images sent to the program",
             "depth images received by the program", "depth images dropped by the server"},
            rows));
}

}  // namespace

std::string report_html(const Session& session, const Summary& summary, const Verdict& verdict,
                        const std::string& view_png) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>telepalp: " +
         escaped(session.name) + "</title>\n<style>" + std::string(kStyle) + "</style></head><body>\n" +
         first_screen(session, summary, verdict) + senders_section(summary) + view_section(session, view_png) +
         notes_section(session) + motion_sections(session, summary) + speech_section(session) +
         states_section(summary) + image_counts_section(session, summary) + timing_sections(session, summary) +
         events_section(session) + page_words_section() + "</body></html>\n";
}

}  // namespace telepalp::report
