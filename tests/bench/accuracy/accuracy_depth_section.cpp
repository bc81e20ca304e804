#include <cmath>

#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "tests/bench/accuracy/accuracy_depth.h"
#include "tests/bench/accuracy/accuracy_sections.h"

namespace telepalp::bench {
namespace {

using codec::DepthMode;

/// Factors of the default bound.
constexpr double kScales[] = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

DepthErrorBound scaled(double scale) {
  constexpr DepthErrorBound usual = codec::kOneDisparityStep;
  return {.least_m = scale * usual.least_m, .per_m = scale * usual.per_m};
}

struct PricedDepth {
  std::string name;
  DepthErrorBound bound;
  DepthPrice price;
};

std::string bound_text(const DepthErrorBound& bound) {
  return "max(" + cell(1e3 * bound.least_m) + ", " + cell(1e3 * bound.per_m) + " z²)";
}

PageTable bounded_table(const std::vector<PricedDepth>& all, double near_m) {
  PageTable table{.head = {"bound, mm (z in m)", "at " + cell(near_m) + " m, mm", "bits per pixel", "ratio",
                           "depth error mm, RMS / max", "force error mN, RMS", "p99", "max"},
                  .rows = {}};
  for (const PricedDepth& one : all)
    table.rows.push_back({one.name.empty() ? bound_text(one.bound) : one.name,
                          one.name.empty() ? cell(1e3 * one.bound.at(near_m)) : "0", cell(one.price.bits_per_pixel),
                          cell(one.price.ratio), cell(one.price.rms_mm) + " / " + cell(one.price.worst_mm),
                          cell(1e3 * one.price.force_rms_N), cell(1e3 * one.price.force_p99_N),
                          cell(1e3 * one.price.force_max_N)});
  return table;
}

/// The force in mN, at least a small value, because a logarithmic axis cannot show zero.
double felt_mN(double force_N) {
  constexpr double kUnfelt_N = 1e-3;
  return force_N < kUnfelt_N ? std::nan("") : 1e3 * force_N;
}

plot::Series curve(const std::vector<PricedDepth>& all, const std::string& name, std::string_view color, bool rare) {
  plot::Series series{name, {}, {}, std::string(color), rare ? plot::Style::Dashed : plot::Style::Line};
  for (auto one = all.rbegin(); one != all.rend(); ++one) {
    if (!one->name.empty()) continue;  // lossless: no error, which a logarithmic axis cannot show
    series.x.push_back(one->price.bits_per_pixel);
    series.y.push_back(felt_mN(rare ? one->price.force_p99_N : one->price.force_rms_N));
  }
  return series;
}

PageTable mode_table(const std::vector<std::vector<PricedDepth>>& by_sequence, const std::vector<std::string>& names) {
  PageTable table{.head = {"mode"}, .rows = {}};
  for (const std::string& name : names)
    for (const char* what : {"ratio", "error mm, RMS / max", "encode / decode ms", "force error mN, RMS"})
      table.head.push_back(name + ": " + what);
  for (std::size_t mode = 0; mode < by_sequence.front().size(); ++mode) {
    table.rows.push_back({"`" + by_sequence.front()[mode].name + "`"});
    for (const std::vector<PricedDepth>& sequence : by_sequence) {
      const DepthPrice& p = sequence[mode].price;
      table.rows.back().push_back(cell(p.ratio));
      table.rows.back().push_back(cell(p.rms_mm) + " / " + cell(p.worst_mm));
      table.rows.back().push_back(cell(p.encode_p50_ms) + " / " + cell(p.decode_p50_ms));
      table.rows.back().push_back(cell(1e3 * p.force_rms_N));
    }
  }
  return table;
}

void add_rows(const std::string& name, const DepthPrice& price, bool lossless, std::vector<Row>& rows) {
  rows.push_back(measured(name + ": bits per pixel", price.bits_per_pixel, ""));
  rows.push_back(measured(name + ": compression ratio", price.ratio, ""));
  rows.push_back(measured(name + ": time to encode a frame, p50", price.encode_p50_ms, "ms"));
  rows.push_back(measured(name + ": time to decode a frame, p50", price.decode_p50_ms, "ms"));
  rows.push_back(lossless ? at_most(name + ": largest depth error", price.worst_mm, "mm", 0.0)
                          : measured(name + ": largest depth error", price.worst_mm, "mm"));
  rows.push_back(measured(name + ": depth error, RMS", price.rms_mm, "mm"));
  rows.push_back(lossless ? at_most(name + ": force error, max", price.force_max_N, "N", 0.0)
                          : measured(name + ": force error, RMS", price.force_rms_N, "N"));
  rows.push_back(measured(name + ": number of places pressed", price.places, ""));
}

Result<std::vector<PricedDepth>> bounds_of(const DepthSequence& sequence, std::vector<Row>& rows) {
  std::vector<PricedDepth> all;
  const Result<DepthPrice> lossless = price_of(sequence, DepthMode::Temporal, {});
  if (!lossless) return lossless.error();
  all.push_back({"without loss (`temporal`)", {}, *lossless});
  for (const double scale : kScales) {
    const Result<DepthPrice> price = price_of(sequence, DepthMode::Bounded, scaled(scale));
    if (!price) return price.error();
    add_rows(sequence.name + ", bound x " + cell(scale), *price, false, rows);
    all.push_back({"", scaled(scale), *price});
  }
  return all;
}

Result<std::vector<PricedDepth>> modes_of(const DepthSequence& sequence, std::vector<Row>& rows) {
  std::vector<PricedDepth> all;
  for (const DepthMode mode : {DepthMode::Fast, DepthMode::Intra, DepthMode::Temporal, DepthMode::Bounded}) {
    const Result<DepthPrice> price = price_of(sequence, mode, codec::kOneDisparityStep);  // the bound of `bounded`
    if (!price) return price.error();
    const std::string name(codec::name(mode));
    add_rows(sequence.name + ", " + name, *price, mode != DepthMode::Bounded, rows);
    all.push_back({name, {}, *price});
  }
  return all;
}

}  // namespace

Result<Section> depth_section() {
  const auto sequences = depth_sequences();
  if (!sequences) return sequences.error();
  Section section;
  plot::Chart chart{
      .title = "Bits that a bound on depth saves, and force error at 500 N/m; marks: times the default bound",
      .x = {.label = "bits per pixel", .logarithmic = false},
      .y = {.label = "force error [mN]", .logarithmic = true}};
  chart.height_px = 400.0;
  constexpr std::string_view kColors[] = {plot::kBlue, plot::kVermilion};
  std::string text;
  std::vector<std::vector<PricedDepth>> modes;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < sequences->size(); ++i) {
    const DepthSequence& sequence = (*sequences)[i];
    const auto bounds = bounds_of(sequence, section.rows);
    if (!bounds) return bounds.error();
    text += (i > 0 ? "\n" : "") + std::string("**") + sequence.name + "**, " +
            std::to_string(bounds->front().price.places) + " places pressed:\n\n" +
            to_markdown(bounded_table(*bounds, 0.8));
    chart.series.push_back(curve(*bounds, sequence.name + ", RMS", kColors[i], false));
    chart.series.push_back(curve(*bounds, sequence.name + ", p99", kColors[i], true));
    for (std::size_t k = 1; k < bounds->size(); ++k)
      chart.marks.push_back({(*bounds)[k].price.bits_per_pixel, felt_mN((*bounds)[k].price.force_rms_N),
                             "x " + cell(kScales[k - 1]), std::string(kColors[i])});
    auto priced = modes_of(sequence, section.rows);
    if (!priced) return priced.error();
    modes.push_back(std::move(priced).value());
    names.push_back(sequence.name);
  }
  section.parts = {{"bounded", text}, {"modes", to_markdown(mode_table(modes, names))}};
  section.pictures = {{"accuracy/bounded.svg", plot::to_svg(chart)}};
  return section;
}

}  // namespace telepalp::bench
