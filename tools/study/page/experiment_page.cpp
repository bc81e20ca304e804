#include "tools/study/page/experiment_page.h"

#include <algorithm>

#include "clients/report/figures/html.h"
#include "proto/words/numbers/fixed_text.h"
#include "support/plot/chart.h"
#include "support/plot/number.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "support/program/json.h"

namespace telepalp::study {
namespace {

using TableCells = std::vector<std::vector<std::string>>;
constexpr std::string_view kCurveColors[] = {plot::kVermilion, plot::kBlue, plot::kGrey};

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed_text(p, 3); }

std::string spread(const Sample& sample) {
  return plot::readable(sample.mean) + " ± " + plot::readable(sample.deviation);
}

std::string unit_of(const Measure& measure) { return measure.unit.empty() ? "" : " [" + measure.unit + "]"; }

const char* test_name(const Experiment& experiment) {
  return experiment.subjects == Subjects::Within ? "paired t-test" : "Welch's t-test";
}

std::string test_text(const TTest& test) {
  return "t = " + fixed_text(test.t, 2) + ", df = " + fixed_text(test.degrees) + ", p " + (test.p < 0.001 ? "" : "= ") +
         p_text(test.p);
}

/// The paper's printed figures with Welch's test of them, which needs nothing else; a paired test needs its people.
std::string paper_text(const Experiment& experiment, const Measure& measure) {
  std::string text = measure.paper_says;
  if (!measure.paper || experiment.subjects == Subjects::Within) return text;
  const TTest again = welch_test(measure.paper->first, measure.paper->second);
  return text + "; computed from the printed means: " + test_text(again);
}

std::string headline(const Experiment& experiment, const Compared& one) {
  return one.measure.name + ": " + plot::readable(one.first.mean) + " " + one.measure.unit + " (" +
         experiment.conditions[0] + "), " + plot::readable(one.second.mean) + " " + one.measure.unit + " (" +
         experiment.conditions[1] + ")";
}

std::string sentence(const Experiment& experiment, const Compared& one) {
  const TTest& test = one.test;
  const std::string change = one.second.mean == 0.0 || one.first.mean == 0.0
                                 ? ""
                                 : ", " + fixed_text(100.0 * (one.second.mean / one.first.mean - 1.0), 0) + " %";
  return one.measure.name + ": the difference " + experiment.conditions[0] + " minus " + experiment.conditions[1] +
         " is " + plot::readable(test.difference) + " (95 % interval " + plot::readable(test.low) + " to " +
         plot::readable(test.high) + ")" + (one.measure.unit.empty() ? "" : " " + one.measure.unit) + change + "; " +
         test_text(test) + ".";
}

TableCells result_rows(const Experiment& experiment, const ExperimentResult& result) {
  TableCells rows;
  for (const Compared& one : result.compared)
    rows.push_back({one.measure.name + unit_of(one.measure), spread(one.first), spread(one.second),
                    plot::readable(one.test.difference) + " (" + plot::readable(one.test.low) + " to " +
                        plot::readable(one.test.high) + ")",
                    fixed_text(one.test.t, 2), fixed_text(one.test.degrees), p_text(one.test.p),
                    fixed_text(one.test.effect, 2), fixed_text(one.test.power, 2),
                    std::to_string(one.people) +
                        (experiment.subjects == Subjects::Within ? "" : " + " + std::to_string(one.people))});
  return rows;
}

std::vector<std::string> result_head(const Experiment& experiment) {
  return {"",
          experiment.conditions[0] + ", mean ± SD",
          experiment.conditions[1] + ", mean ± SD",
          "difference (95 %)",
          "t",
          "df",
          "p",
          "d",
          "power",
          "people for power 0.8"};
}

TableCells paper_rows(const Experiment& experiment, const ExperimentResult& result) {
  TableCells rows;
  for (const Compared& one : result.compared) {
    if (!one.measure.paper && one.measure.paper_says.empty()) continue;
    const auto& paper = one.measure.paper;
    const auto ratio = [](const Sample& first, const Sample& second) {
      return fixed_text(100.0 * (second.mean / first.mean - 1.0), 0) + " %";
    };
    rows.push_back({one.measure.name + unit_of(one.measure), paper ? spread(paper->first) : "",
                    paper ? spread(paper->second) : "", paper ? ratio(paper->first, paper->second) : "",
                    ratio(one.first, one.second), paper_text(experiment, one.measure)});
  }
  return rows;
}

/// All observers' values from the least to the largest, one curve for each condition: what share lies below a value.
std::string distribution_chart(const Experiment& experiment, const Compared& one) {
  plot::Chart chart{.title = one.measure.name + " of all observers",
                    .x = {.label = one.measure.name + unit_of(one.measure), .include = plot::Range{0.0, 0.0}},
                    .y = {.label = "observers below [%]", .include = plot::Range{0.0, 100.0}},
                    .height_px = 260.0};
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<double> values = c == 0 ? one.measure.first : one.measure.second;
    std::sort(values.begin(), values.end());
    plot::Series series{.name = experiment.conditions[c],
                        .x = {},
                        .y = {},
                        .color = std::string(kCurveColors[c]),
                        .style = plot::Style::Path};
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (const std::size_t share : {i, i + 1}) {
        series.x.push_back(values[i]);
        series.y.push_back(100.0 * static_cast<double>(share) / static_cast<double>(values.size()));
      }
    }
    chart.series.push_back(std::move(series));
    if (one.measure.paper)
      chart.rules.push_back({.at = c == 0 ? one.measure.paper->first.mean : one.measure.paper->second.mean,
                             .label = "S3",
                             .color = std::string(kCurveColors[c]),
                             .vertical = true});
  }
  return plot::to_svg(chart);
}

std::string curves_chart(const Curves& curves) {
  plot::Chart chart{
      .title = curves.title, .x = {.label = curves.x_label}, .y = {.label = curves.y_label}, .height_px = 260.0};
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
    chart.series.push_back({.name = curves.curves[i].name,
                            .x = curves.curves[i].x,
                            .y = curves.curves[i].y,
                            .color = std::string(kCurveColors[i]),
                            .style = plot::Style::Line});
  return plot::to_svg(chart);
}

std::string rules_text(const Experiment& experiment) {
  const bool within = experiment.subjects == Subjects::Within;
  return "<dl class=\"meanings\"><dt>test</dt><dd>" + std::string(test_name(experiment)) +
         ", two-sided, not corrected for the number of tests</dd><dt>interval</dt><dd>95 %, by the same t</dd>"
         "<dt>d</dt><dd>Cohen's: the difference over " +
         (within ? "the standard deviation of the differences" : "the standard deviation, pooled") +
         "</dd><dt>power</dt><dd>after the study, as in the papers: the chance of p &lt; 0.05 if the true effect were "
         "the measured one. It says nothing that p does not say</dd><dt>people for power 0.8</dt><dd>how many " +
         (within ? "people" : "people in each group") +
         " a study needs, if their effect is this one. The number grows with the inverse square of the effect</dd>"
         "<dt>order</dt><dd>" +
         (within ? "each order of the conditions is equally frequent, and drawn by the seed"
                 : "of each two observers, one is drawn for either condition, by the seed") +
         "</dd></dl>";
}

std::string range_section(const Experiment& experiment) {
  TableCells rows;
  for (const RangeWords& one : experiment.ranges) rows.push_back({one.name, one.range, one.source});
  return report::section("Observers and task", "Each value is drawn evenly from its range, once for each observer.",
                         report::table({"parameter", "range", "source"}, rows, report::Cells::Words));
}

void add(program::Json& json, std::string_view key, const Sample& sample) {
  json.begin_object(key);
  json.add("mean", sample.mean);
  json.add("deviation", sample.deviation);
  json.add("count", static_cast<std::uint64_t>(sample.count));
  json.end_object();
}

void add(program::Json& json, const Compared& one) {
  json.begin_object();
  json.add("name", one.measure.name);
  json.add("unit", one.measure.unit);
  add(json, "first", one.first);
  add(json, "second", one.second);
  json.add("difference", one.test.difference);
  json.add("low", one.test.low);
  json.add("high", one.test.high);
  json.add("t", one.test.t);
  json.add("degrees", one.test.degrees);
  json.add("p", one.test.p);
  json.add("effect", one.test.effect);
  json.add("power", one.test.power);
  json.add("people_for_power_0.8", static_cast<std::uint64_t>(one.people));
  if (one.measure.paper) {
    add(json, "paper_first", one.measure.paper->first);
    add(json, "paper_second", one.measure.paper->second);
  }
  json.end_object();
}

}  // namespace

Result<ExperimentResult> result_of(const Experiment& experiment, const std::vector<Row>& rows) {
  ExperimentResult out;
  for (Measure& measure : experiment.measures(rows)) {
    Compared one{.measure = std::move(measure), .first = {}, .second = {}, .test = {}};
    if (one.measure.first.size() < 2 || one.measure.second.size() < 2)
      return Error{.what = "a condition has fewer than two observers, which have no spread",
                   .where = "--observers",
                   .fix = "give 4 or more"};
    one.first = sample_of(one.measure.first);
    one.second = sample_of(one.measure.second);
    const bool within = experiment.subjects == Subjects::Within;
    one.test = within ? paired_test(one.measure.first, one.measure.second) : welch_test(one.first, one.second);
    one.people = people_for_power(one.test.effect, within);
    out.compared.push_back(std::move(one));
  }
  out.findings = experiment.findings(rows);
  out.curves = experiment.curves(rows);
  return out;
}

std::string experiment_text(const Experiment& experiment, const ExperimentResult& result) {
  std::string text = experiment.title + "\n\n";
  for (const Compared& one : result.compared) {
    text += sentence(experiment, one) + "\n";
    text += "  " + experiment.conditions[0] + " " + spread(one.first) + ", " + experiment.conditions[1] + " " +
            spread(one.second) + "; d " + fixed_text(one.test.effect, 2) + ", power " + fixed_text(one.test.power, 2) +
            "\n";
    if (one.measure.paper)
      text += "  S3: " + experiment.conditions[0] + " " + spread(one.measure.paper->first) + ", " +
              experiment.conditions[1] + " " + spread(one.measure.paper->second) + "; " +
              paper_text(experiment, one.measure) + "\n";
  }
  for (const std::string& finding : result.findings) text += finding + "\n";
  return text + "All observers are simulated. What they cannot show: " + experiment.limits.front() + "\n";
}

std::string experiment_json(const Experiment& experiment, const ExperimentSettings& settings,
                            const ExperimentResult& result) {
  program::Json json;
  json.begin_object();
  json.add("program", "telepalp-study");
  json.add("identity", parts_of(experiment, settings).identity);
  json.add("study", experiment.name);
  json.add("observers", static_cast<std::uint64_t>(settings.observers));
  json.add("seed", settings.seed);
  json.add("test", test_name(experiment));
  json.add("first", experiment.conditions[0]);
  json.add("second", experiment.conditions[1]);
  json.begin_list("measures");
  for (const Compared& one : result.compared) add(json, one);
  json.end_list();
  json.end_object();
  return std::move(json).finish();
}

std::string experiment_html(const Experiment& experiment, const ExperimentSettings& settings,
                            const ExperimentResult& result) {
  std::string page = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                     plot::escaped(experiment.title) +
                     "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
                     std::string(report::kStyle) + "</style></head><body><h1>" + plot::escaped(experiment.title) +
                     "</h1><p class=\"from\">" + plot::escaped(parts_of(experiment, settings).identity) + "; " +
                     std::to_string(settings.observers) + " simulated observers</p>";
  page += "<div class=\"verdict none\"><div class=\"headline\">" +
          plot::escaped(headline(experiment, result.compared.front())) + "</div>";
  for (const Compared& one : result.compared) page += "<p>" + plot::escaped(sentence(experiment, one)) + "</p>";
  for (const std::string& finding : result.findings) page += "<p>" + plot::escaped(finding) + "</p>";
  page += "<p>All observers are simulated. No person took part.</p></div>";
  std::string limits = "<ul>";
  for (const std::string& limit : experiment.limits) limits += "<li>" + plot::escaped(limit) + "</li>";
  page += report::section("What simulated observers cannot show", "Read this before the figures.", limits + "</ul>");
  std::string charts;
  for (const Compared& one : result.compared) charts += distribution_chart(experiment, one);
  page +=
      report::section("Result", plot::escaped(experiment.task),
                      "<div class=\"scroll\">" +
                          report::table(result_head(experiment), result_rows(experiment, result)) + "</div>" + charts);
  if (const TableCells paper = paper_rows(experiment, result); !paper.empty())
    page += report::section("Beside S3", "The paper's printed figures, from people. No range was fitted to them.",
                            report::table({"", "S3, " + experiment.conditions[0], "S3, " + experiment.conditions[1],
                                           "change, S3", "change, here", "S3 says"},
                                          paper, report::Cells::Words));
  std::string pictures;
  for (const Curves& curves : result.curves) pictures += curves_chart(curves);
  page += report::section("Single trials", "", pictures);
  page += report::section("Rules", "What the words of this page mean.", rules_text(experiment));
  return page + range_section(experiment) + "</body></html>\n";
}

}  // namespace telepalp::study
