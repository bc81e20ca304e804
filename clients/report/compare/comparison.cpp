#include "clients/report/compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clients/ar/messages/phases.h"
#include "clients/report/compare/cause.h"
#include "clients/report/figures/view.h"
#include "proto/wire/mcap/first_difference.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using plot::number;
using plot::readable;

/// "Likely causes: 1. …; 2. …." with the most likely ones.
std::string causes_sentence(const Comparison& comparison) {
  constexpr std::size_t kMost = 4;
  const std::vector<std::string> causes = causes_of(comparison);
  if (causes.size() == 1) return "Likely cause: " + causes.front() + ".";
  std::string text = "Likely causes:";
  for (std::size_t i = 0; i < std::min(kMost, causes.size()); ++i)
    text += (i == 0 ? " " : "; ") + std::to_string(i + 1) + ". " + causes[i];
  return text + ".";
}

/// True if something that a user must know differs although no force in contact does.
bool images_differ(const Comparison& comparison) {
  constexpr double kLeast_pct = 1.0;
  return comparison.images.missing_pct() > kLeast_pct;
}

std::string images_sentence(const Comparison& comparison) {
  if (!images_differ(comparison)) return "";
  const ImageComparison& images = comparison.images;
  return " But " + plot::number(images.missing_pct(), 0) + " % of the depth images " +
         (images.surfaces ? "that became a surface " : "") + "are in one run alone (" + std::to_string(images.a) +
         " in A, " + std::to_string(images.b) + " in B).";
}

bool settings_differ(const Comparison& comparison) {
  return std::any_of(comparison.settings.begin(), comparison.settings.end(),
                     [](const Setting& setting) { return setting.differs(); });
}

}  // namespace

Result<Comparison> compare(const std::filesystem::path& a, const std::filesystem::path& b) {
  Result<Run> first = read_run(a);
  if (!first) return first.error();
  Result<Run> second = read_run(b);
  if (!second) return second.error();
  Comparison result{.a = std::move(*first),
                    .b = std::move(*second),
                    .settings = {},
                    .ticks = {},
                    .metrics = {},
                    .replay_metrics = {}};
  label(result.a, result.b);
  result.settings = settings_of(result.a, result.b);
  result.ticks = compare_ticks(result.a.session, result.b.session);
  result.contacts = compare_contacts(result.a.session, result.b.session);
  result.images = compare_images(result.a.session, result.b.session);
  const Result<void> depths =
      compare_depths(result.images, result.a.file, result.a.session, result.b.file, result.b.session);
  if (!depths) return depths.error();
  result.metrics = metric_pairs(result.a.summary, result.b.summary);
  result.replay_metrics = replay_metric_pairs(result.a, result.b);
  result.messages_compared = share_time(result.a.session, result.b.session);
  if (!result.messages_compared) return result;
  Result<std::optional<std::string>> difference = wire::first_difference(result.a.file, result.b.file);
  if (!difference) return difference.error();
  result.first_message = std::move(*difference);
  return result;
}

double Comparison::depth_ratio() const noexcept {
  if (std::isfinite(images.depth_ratio)) return images.depth_ratio;
  return a.replay && b.replay ? b.replay->mean_depth_m / a.replay->mean_depth_m : kUnknown;
}

std::string headline(const Comparison& comparison) {
  if (comparison.equal()) return "The two runs are equal, message by message.";
  const TickComparison& ticks = comparison.ticks;
  if (ticks.common == 0)
    return "The two runs have no 2 kHz ticks at the same time, so only their summary figures are compared.";
  if (!ticks.first_felt)
    return "The hand feels no difference: in contact, the forces of the two runs differ by at most " +
           readable(kFelt_N) + " N." + images_sentence(comparison);
  return "The hand first feels a difference " + number(ticks.first_felt->at_s, 3) +
         " s after the start: " + forces_in_words(comparison.a, comparison.b, *ticks.first_felt) + ".";
}

std::string account(const Comparison& comparison) {
  const TickComparison& ticks = comparison.ticks;
  std::string text;
  if (ticks.first_felt || images_differ(comparison) || settings_differ(comparison)) text = causes_sentence(comparison);
  if (!settings_differ(comparison))
    text += std::string(text.empty() ? "" : " ") + "Both runs record the same settings.";
  if (ticks.common == 0 || comparison.equal()) return text;
  const double share = 100.0 * static_cast<double>(ticks.phase_other) / static_cast<double>(ticks.common);
  text += " Over all " + std::to_string(ticks.common) +
          " ticks that both runs have, in contact or not, the device's forces are " + readable(ticks.force_rms_N) +
          " N apart (RMS)";
  if (ticks.largest)
    text += ", at most " + readable(ticks.largest->force_apart_N) + " N, " + number(ticks.largest->at_s, 3) +
            " s after the start";
  return text + ", and the states differ at " + readable(share) +
         " % of the ticks. Out of contact the force moves the device; the hand feels only the lift in the state "
         "“" +
         std::string(ar::words_for(msg::PHASE_BODY_TO_PLANE).words) + "”.";
}

double pictured_s(const Comparison& comparison) {
  if (comparison.ticks.largest) return comparison.ticks.largest->at_s;
  const Session& a = comparison.a.session;
  return 1e-9 * static_cast<double>(deepest_moment_ns(a) - common_origins(a, comparison.b.session).a_ns);
}

}  // namespace telepalp::report
