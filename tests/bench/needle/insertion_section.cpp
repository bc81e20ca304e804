#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "haptic_station/tissue/fit/insertion_fit.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using Curves = std::map<std::string, tissue::InsertionCurve>;  // by the file's name

/// The text of a file, unpacked if it is packed by gzip; at most 16 MB.
std::string text_of(const fs::path& file) {
  constexpr std::size_t kMost_B = 16'000'000;
  std::string text(kMost_B, '\0');
  const gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) return {};
  const int got = gzread(in, text.data(), static_cast<unsigned>(text.size()));
  gzclose(in);
  text.resize(static_cast<std::size_t>(std::max(0, got)));
  return text;
}

/// The part of a record `displacement_mm,force_N` in which the needle goes in. A record's displacement is noisy, so a
/// sample that is not deeper than all before it is left out, and the part ends 0.1 mm above the greatest depth.
tissue::InsertionCurve read_curve(const fs::path& file) {
  std::istringstream lines(text_of(file));
  std::string line;
  std::getline(lines, line);
  tissue::InsertionCurve all;
  double mm = 0.0;
  double force_N = 0.0;
  char comma = 0;
  while (std::getline(lines, line))
    if (std::istringstream row(line); row >> mm >> comma >> force_N) {
      all.depth_m.push_back(1e-3 * mm);
      all.force_N.push_back(force_N);
    }
  tissue::InsertionCurve in;
  if (all.depth_m.empty()) return in;
  const double end_m = *std::ranges::max_element(all.depth_m) - 1e-4;
  for (std::size_t i = 0; i < all.depth_m.size() && (in.depth_m.empty() || in.depth_m.back() < end_m); ++i) {
    if (!in.depth_m.empty() && all.depth_m[i] <= in.depth_m.back()) continue;
    in.depth_m.push_back(all.depth_m[i]);
    in.force_N.push_back(all.force_N[i]);
  }
  return in;
}

/// Curves whose names begin with one of two prefixes.
Curves read_curves(const fs::path& folder, const std::string& one, const std::string& other) {
  Curves curves;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string(); name.starts_with(one) || name.starts_with(other))
      curves.emplace(name, read_curve(entry.path()));
  return curves;
}

/// Adds the relative error of `fit` on `curve` [%]; infinite if there is no fit.
void add_error(Distribution& percent, const Result<tissue::InsertionFit>& fit, const tissue::InsertionCurve& curve) {
  const Result<double> error = fit ? tissue::relative_error(*fit, curve) : Result<double>(fit.error());
  percent.add(error ? 100.0 * *error : HUGE_VAL);
}

/// Share of the samples that are at most `limit`, in whole percent.
double share_within(const Distribution& percent, double limit) {
  double share = 0.0;
  for (int i = 1; i <= 100; ++i)
    if (percent.quantile(0.01 * i) <= limit) share = i;
  return share;
}

/// Errors of each curve of a liver, by a model of the liver's other curves.
void add_errors_of_others(Distribution& percent, const Curves& liver) {
  for (const auto& [name, curve] : liver) {
    std::vector<tissue::InsertionCurve> others;
    for (const auto& [other, of_other] : liver)
      if (other != name) others.push_back(of_other);
    add_error(percent, tissue::fit_insertion(others), curve);
  }
}

/// Median, share within 15 %, and worst of errors on curves that no model has seen.
void add_held_out(std::vector<Row>& rows, const std::string& name, const Distribution& percent) {
  rows.push_back(at_most(name + ": RMS over peak force, median", percent.p50(), "%", 12.0));
  rows.push_back(at_least(name + ": share within 15 %", share_within(percent, 15.0), "%", 85.0));
  rows.push_back(measured(name + ": worst", percent.max(), "%"));
}

}  // namespace

/// The first liver's curves are liver_00 to liver_19, the second's liver_20 to liver_39. Each curve is judged by a
/// model that is fitted to this curve alone, and by one of the other curves of its liver; those of the second liver
/// also by one model that is fitted to all of the first.
std::vector<Row> run_needle_insertion_section(const std::string& folder) {
  const Curves first = read_curves(folder, "liver_0", "liver_1");
  const Curves second = read_curves(folder, "liver_2", "liver_3");
  std::vector<Row> rows{measured("insertions: curves of the first and of the second liver",
                                 static_cast<double>(first.size() + second.size()), "")};
  Distribution own;
  Distribution held_out;
  std::vector<tissue::InsertionCurve> all;
  for (const auto& [name, curve] : first) all.push_back(curve);
  const Result<tissue::InsertionFit> of_first = tissue::fit_insertion(all);
  for (const Curves* liver : std::initializer_list<const Curves*>{&first, &second})
    for (const auto& [name, curve] : *liver) add_error(own, tissue::fit_insertion({&curve, 1}), curve);
  for (const auto& [name, curve] : second) add_error(held_out, of_first, curve);
  rows.push_back(at_most("insertions, fitted to their own curve: RMS over peak force, median", own.p50(), "%", 5.0));
  rows.push_back(at_most("insertions, fitted to their own curve: RMS over peak force, worst", own.max(), "%", 10.0));
  Distribution by_others;
  add_errors_of_others(by_others, first);
  add_errors_of_others(by_others, second);
  add_held_out(rows, "insertions, model of the liver's other curves", by_others);
  add_held_out(rows, "insertions of the second liver, model of the first", held_out);
  return rows;
}

}  // namespace telepalp::bench
