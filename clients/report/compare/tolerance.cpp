#include "clients/report/compare/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "clients/report/compare/comparison.h"
#include "proto/words/number_word.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::readable;

/// The defaults are above what a change of compiler or a rounding gives, and below what a hand notices: forces as a
/// tenth of a newton, contact as a millimetre, latency as a third of a frame.
constexpr auto kDefaults = std::to_array<Tolerance>({
    {"force_rms_N", "N", "RMS difference of the force vectors in contact", 0.1},
    {"force_p99_N", "N", "99th percentile of the difference of the force vectors in contact", 0.5},
    {"stiffness_pct", "%", "difference of the force at equal indentation", 5.0},
    {"contact_mm", "mm", "distance by which contacts begin deeper or less deep", 1.0},
    {"contact_pct", "%", "share of the time in contact at which one run alone is in contact", 5.0},
    {"images_pct", "%", "share of the depth images that one run alone has", 5.0},
    {"depth_pct", "%", "difference of the depths of the same image", 0.2},
    {"camera_pct", "%", "difference of the depth camera's focal lengths and principal point, of the focal length", 0.1},
    {"depth_bound_mm", "mm", "difference of the error bounds of the depth coding, 1 m from the camera", 0.5},
    {"missing_s", "s", "recorded time that one run alone has", 0.1},
    {"latency_ms", "ms", "difference of a median age: of the touched surface, or of an image when it became touchable",
     10.0},
    {"latency_p99_ms", "ms", "the same of a 99th percentile", 50.0},
});

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A figure of both runs. Without it in one run, the difference is infinite; without it in both, unknown.
double apart(double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(b - a);
  return std::isfinite(a) || std::isfinite(b) ? kInfinite : kUnknown;
}

struct Found {
  double value = kUnknown;
  std::string detail{};
};

std::string both(double a, double b, const char* unit) {
  return readable(a) + " " + unit + " in A, " + readable(b) + " " + unit + " in B";
}

Found ages(const Comparison& comparison, double Quantiles::*part) {
  const Summary &a = comparison.a.summary, &b = comparison.b.summary;
  const auto of = [&](Quantiles Summary::*figure, const char* name) {
    const double in_a = (a.*figure).*part, in_b = (b.*figure).*part;
    return Found{apart(in_a, in_b), std::string(name) + " " + both(in_a, in_b, "ms")};
  };
  Found found = of(&Summary::surface_age_ms, "touched surface");
  for (const Found& other : {of(&Summary::capture_to_touchable_ms, "camera to hand"),
                             of(&Summary::assumed_age_ms, "age that the station assumes")})
    if (other.value > found.value || std::isnan(found.value)) found = other;
  return found;
}

Found contact_share(const TickComparison& ticks) {
  if (ticks.contact == 0) return {};
  return {100.0 * static_cast<double>(ticks.one_sided) / static_cast<double>(ticks.contact)};
}

Found contact_depth(const ContactComparison& contacts) {
  if (contacts.contacts_a > 0 && contacts.contacts_b > 0 && contacts.pairs == 0)
    return {kInfinite, "no contact of B begins within 0.4 s of one of A"};
  if ((contacts.contacts_a > 0) != (contacts.contacts_b > 0))
    return {kInfinite,
            std::to_string(contacts.contacts_a) + " contacts in A, " + std::to_string(contacts.contacts_b) + " in B"};
  return {std::abs(contacts.deeper_mm)};
}

Found missing_time(const Comparison& comparison) {
  const Session &a = comparison.a.session, &b = comparison.b.session;
  if (a.ticks.size() == 0 && b.ticks.size() == 0)
    return {apart(seconds(a), seconds(b)), both(seconds(a), seconds(b), "s")};
  const std::size_t most = std::max(comparison.ticks.missing_in_a.count, comparison.ticks.missing_in_b.count);
  if (a.ticks.size() == 0 || b.ticks.size() == 0) return {kInfinite, "one run has no ticks"};
  return {1e-9 * static_cast<double>(most) * a.ticks.period_ns};
}

double camera_apart_pct(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty()) return a.empty() && b.empty() ? kUnknown : kInfinite;
  double most_px = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) most_px = std::max(most_px, std::abs(a[i] - b[i]));
  return 100.0 * most_px / a.front();
}

Found found(std::string_view name, const Comparison& comparison) {
  if (name == "force_rms_N") return {comparison.ticks.contact_rms_N};
  if (name == "force_p99_N") return {comparison.ticks.contact_p99_N};
  if (name == "stiffness_pct") return {100.0 * std::abs(comparison.contacts.force_ratio - 1.0)};
  if (name == "contact_mm") return contact_depth(comparison.contacts);
  if (name == "contact_pct") return contact_share(comparison.ticks);
  const ImageComparison& images = comparison.images;
  if (name == "images_pct")
    return {images.missing_pct(), std::to_string(images.a) + " in A, " + std::to_string(images.b) + " in B"};
  if (name == "depth_pct") return {100.0 * std::abs(comparison.depth_ratio() - 1.0)};
  if (name == "depth_bound_mm") return {apart(comparison.a.depth_bound_mm(), comparison.b.depth_bound_mm())};
  if (name == "camera_pct") return {camera_apart_pct(comparison.a.camera_px(), comparison.b.camera_px())};
  if (name == "missing_s") return missing_time(comparison);
  return ages(comparison, name == "latency_ms" ? &Quantiles::p50 : &Quantiles::p99);
}

Error refused(std::string_view word, const std::string& what, std::string_view option) {
  return {.what = "'" + std::string(word) + "' " + what,
          .where = std::string(option),
          .fix = "give same, or replace some of " + default_tolerances_in_words()};
}

Result<void> replace(std::vector<Tolerance>& tolerances, std::string_view word, std::string_view option) {
  word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
  const std::size_t sign = word.find("<=");
  if (sign == std::string_view::npos) return refused(word, "is not NAME<=NUMBER", option);
  const std::string_view name = word.substr(0, sign), text = word.substr(sign + 2);
  const auto place =
      std::find_if(tolerances.begin(), tolerances.end(), [&](const auto& one) { return one.name == name; });
  if (place == tolerances.end()) return refused(word, "names no tolerance", option);
  const std::optional<double> at_most = finite_number_of(text);
  if (!at_most || *at_most < 0.0) return refused(word, "does not give a number of at least 0", option);
  place->at_most = *at_most;
  return {};
}

}  // namespace

std::span<const Tolerance> default_tolerances() noexcept { return kDefaults; }

std::string default_tolerances_in_words() {
  std::string text;
  for (const Tolerance& tolerance : kDefaults)
    text += (text.empty() ? "" : ", ") + std::string(tolerance.name) + "<=" + plot::number(tolerance.at_most);
  return text;
}

Result<std::vector<Tolerance>> parse_tolerances(std::string_view text, std::string_view option) {
  std::vector<Tolerance> tolerances(kDefaults.begin(), kDefaults.end());
  if (text == "same") return tolerances;
  for (std::string_view rest = text;;) {
    const std::size_t end = rest.find(',');
    if (const Result<void> replaced = replace(tolerances, rest.substr(0, end), option); !replaced)
      return replaced.error();
    if (end == std::string_view::npos) return tolerances;
    rest = rest.substr(end + 1);
  }
}

bool Difference::holds() const noexcept { return std::isnan(value) || value <= tolerance.at_most; }

std::vector<Difference> differences_of(const Comparison& comparison, const std::vector<Tolerance>& tolerances) {
  std::vector<Difference> all;
  for (const Tolerance& tolerance : tolerances) {
    Found one = found(tolerance.name, comparison);
    all.push_back({tolerance, one.value, std::move(one.detail)});
  }
  return all;
}

}  // namespace telepalp::report
