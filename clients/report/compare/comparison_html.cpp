#include "clients/report/compare/comparison_html.h"

#include <cmath>

#include "clients/report/compare/cause.h"
#include "clients/report/compare/overlay_figures.h"
#include "clients/report/figures/html.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"
#include "support/plot/svg.h"

namespace telepalp::report {
namespace {

using plot::escaped;
using plot::number;
using plot::readable;

constexpr std::string_view kPairStyle = R"css(
.a { color: #0072b2; } .b { color: #d55e00; } .a, .b { font-weight: 650; }
td.text { text-align: left; overflow-wrap: anywhere; } tr.worse td { background: #fff6ef; }
pre { background: #f6f7f9; padding: 10px 12px; border-radius: 6px; overflow-x: auto; white-space: pre-wrap; font-size: 13px; }
figure { margin: 0; } figcaption { font-size: 14px; margin: 4px 0 0; }
)css";

std::string name_of(const char* letter, const Run& run) {
  return "<span class=\"" + std::string(letter[0] == 'A' ? "a" : "b") + "\">" + letter + "</span> " +
         escaped(run.label) + " · " + number(run.summary.seconds, 1) + " s from the first message to the last · " +
         counted(run.session.messages, "message", "messages");
}

std::string first_screen(const Comparison& comparison) {
  std::string out = "<h1>telepalp: two runs side by side</h1>\n<p class=\"from\">" + name_of("A", comparison.a) +
                    "<br>\n" + name_of("B", comparison.b) + "</p>\n";
  const char* const look = comparison.ticks.first_felt ? " look" : comparison.ticks.common == 0 ? " none" : "";
  out += "<div class=\"verdict" + std::string(look) + "\"><div class=\"headline\">" + escaped(headline(comparison)) +
         "</div><p>" + escaped(account(comparison)) + "</p>\n";
  for (const auto& [letter, run] : {std::pair{"A", &comparison.a}, {"B", &comparison.b}})
    out += "<p>" + std::string(letter) + " alone: " + escaped(run->verdict.headline) + "</p>\n";
  return out + "</div>\n";
}

std::string cell(const std::string& text) {
  return "<td class=\"text\">" + (text.empty() ? "not stated" : escaped(text)) + "</td>";
}

std::string settings_section(const Comparison& comparison) {
  std::string rows, same;
  for (const Setting& setting : comparison.settings) {
    if (setting.differs())
      rows += "<tr><td>" + escaped(setting.name) + "</td>" + cell(setting.a) + cell(setting.b) + "</tr>\n";
    else
      same += (same.empty() ? "" : " · ") + setting.name + ": " + setting.a;
  }
  std::string content;
  if (!rows.empty())
    content = "<table><thead><tr><th>setting</th><th class=\"a\">A</th><th class=\"b\">B</th></tr></thead><tbody>\n" +
              rows + "</tbody></table>\n";
  if (!same.empty()) content += "<p>The same in both: " + escaped(same) + "</p>\n";
  return section("Settings",
                 rows.empty() ? "The sessions record the same settings."
                              : "First the settings that differ, then those that are equal.",
                 content);
}

/// What the stations published at `instant` says about the cause; the paragraph's end.
std::string why(const Comparison& comparison, const Instant& instant) {
  const std::string cause = cause_in_words(comparison.a, comparison.b, instant);
  return (cause.empty() ? "" : " At this instant " + escaped(cause) + ".") + "</p>\n";
}

std::string first_difference_section(const Comparison& comparison) {
  std::string content;
  if (const auto& state = comparison.ticks.first_phase)
    content += "<p>The states first differ at " + number(state->at_s, 4) +
               " s after the start: " + escaped(states_in_words(comparison.a, comparison.b, *state)) + "." +
               why(comparison, *state);
  if (const auto& felt = comparison.ticks.first_felt)
    content += "<p>The forces in contact first differ by more than 0.05 N at " + number(felt->at_s, 4) +
               " s after the start: " + escaped(forces_in_words(comparison.a, comparison.b, *felt)) + "." +
               why(comparison, *felt);
  const auto shown = comparison.ticks.first_felt ? comparison.ticks.first_felt : comparison.ticks.first_phase;
  if (shown) content += plot::to_svg(around(comparison.a.session, comparison.b.session, *shown));
  if (!comparison.messages_compared)
    content += "<p>The sessions were recorded at different times, so their messages are not compared one by one.</p>\n";
  else if (comparison.first_message)
    content += "<p>The first message in which the files differ (A → B; times are session times):</p>\n<pre>" +
               escaped(*comparison.first_message) + "</pre>\n";
  return section("The first difference",
                 comparison.equal()
                     ? "The sessions do not differ: topics, times and bytes of all messages are equal."
                     : "The first tick at which the states differ, and the first tick in contact at which the forces "
                       "differ by more than 0.05 N.",
                 content);
}

std::string difference_of(const MetricPair& pair) {
  if (!std::isfinite(pair.a) || !std::isfinite(pair.b)) return "–";
  const double by = pair.b - pair.a;
  if (by == 0.0) return "0";
  if (pair.same())
    return "the same (less than " + readable(pair.matters) + (pair.unit.empty() ? "" : " " + pair.unit) + " apart)";
  std::string text = (by > 0.0 ? "+" : "−") + readable(std::abs(by));
  if (pair.a != 0.0)
    text += " (" + std::string(by / pair.a > 0.0 ? "+" : "−") + readable(100.0 * std::abs(by / pair.a)) + " %)";
  return text;
}

std::string metric_rows(const std::vector<MetricPair>& pairs) {
  std::string out =
      "<table><thead><tr><th>figure</th><th class=\"a\">A</th><th class=\"b\">B</th><th>B − "
      "A</th></tr></thead><tbody>\n";
  for (const MetricPair& pair : pairs) {
    const std::string unit = pair.unit.empty() ? "" : " [" + pair.unit + "]";
    out += std::string(pair.worse() ? "<tr class=\"worse\">" : "<tr>") + "<td>" + escaped(pair.name + unit) +
           (pair.worse() ? " ▲ worse in B" : "") + "</td><td>" + readable(pair.a) + "</td><td>" + readable(pair.b) +
           "</td><td>" + difference_of(pair) + "</td></tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::string metrics_sections(const Comparison& comparison) {
  std::string out;
  if (!comparison.replay_metrics.empty())
    out += section(
        "Effect of the network",
        "Metrics of telepalp-replay: each run compared with the run over a network without delay, loss and faults, and "
        "with the true skin where the skin is known. docs/replay.md defines each metric.",
        metric_rows(comparison.replay_metrics));
  return out +
         section(
             "Figures of the sessions",
             "Each figure in both runs, and the difference B − A, also in % of A. A row is marked where B is worse. A "
             "difference too small to matter is called the same.",
             metric_rows(comparison.metrics));
}

std::string overlay_sections(const Comparison& comparison) {
  const Session &a = comparison.a.session, &b = comparison.b.session;
  std::string out;
  if (const auto charts = overlaid(a, b, comparison.ticks); !charts.empty())
    out += section("The whole runs",
                   "State, force and height over one time axis. A is blue, B is red; B's states are drawn a little "
                   "above their line. The numbers are those of paper S1 (docs/sources.md); R and F are not in S1.",
                   plot::to_svg(charts));
  if (const auto charts = overlaid_ages(a, b); !charts.empty())
    out += section("Age of the surface", "Age of the surface from which the force was computed.", plot::to_svg(charts));
  return out;
}

std::string figure(const char* letter, const std::string& png) {
  if (png.empty())
    return "<figure><figcaption>" + std::string(letter) +
           ": the session holds no depth image that can be decoded, or no calibration of its "
           "camera.</figcaption></figure>\n";
  return "<figure><img alt=\"run " + std::string(letter) + "\" src=\"data:image/png;base64," + base64(png) +
         "\"><figcaption>" + letter + "</figcaption></figure>\n";
}

std::string pictures_section(const Comparison& comparison, const PicturePair& pictures) {
  if (pictures.a.empty() && pictures.b.empty()) return {};
  return section("The pictures at " + number(pictured_s(comparison), 2) + " s",
                 comparison.ticks.largest
                     ? "Both runs at the largest difference of the forces."
                     : "Both runs at A's deepest touch; if A has no touch, at a time without touch.",
                 "<div class=\"pair\">\n" + figure("A", pictures.a) + figure("B", pictures.b) + "</div>\n");
}

}  // namespace

std::string comparison_html(const Comparison& comparison, const PicturePair& pictures) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>telepalp: " +
         escaped(comparison.a.label + " and " + comparison.b.label) + "</title>\n<style>" + std::string(kStyle) +
         std::string(kPairStyle) + "</style></head><body>\n" + first_screen(comparison) + settings_section(comparison) +
         first_difference_section(comparison) + metrics_sections(comparison) + overlay_sections(comparison) +
         pictures_section(comparison, pictures) + "</body></html>\n";
}

}  // namespace telepalp::report
