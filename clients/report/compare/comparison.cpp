#include "clients/report/compare/comparison.h"

#include <algorithm>
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

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::vector<std::string> differing(const std::vector<Setting>& settings) {
  std::vector<std::string> names;
  for (const Setting& setting : settings)
    if (setting.differs()) names.push_back(setting.name);
  return names;
}

std::string settings_sentence(const Comparison& comparison) {
  const std::vector<std::string> names = differing(comparison.settings);
  if (names.empty()) return "The sessions record the same settings.";
  return "These settings differ: " + joined(names) + ".";
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
  result.metrics = metric_pairs(result.a.summary, result.b.summary);
  result.replay_metrics = replay_metric_pairs(result.a, result.b);
  result.messages_compared = share_time(result.a.session, result.b.session);
  if (!result.messages_compared) return result;
  Result<std::optional<std::string>> difference = wire::first_difference(result.a.file, result.b.file);
  if (!difference) return difference.error();
  result.first_message = std::move(*difference);
  return result;
}

std::string headline(const Comparison& comparison) {
  if (comparison.equal()) return "The two runs are equal, message by message.";
  const TickComparison& ticks = comparison.ticks;
  if (ticks.common == 0)
    return "The two runs have no 2 kHz ticks at the same time, so only their summary figures are compared.";
  if (!ticks.first_felt)
    return "The hand feels no difference: in contact, the forces of the two runs differ by at most " +
           readable(kFelt_N) + " N.";
  return "The hand first feels a difference " + number(ticks.first_felt->at_s, 3) +
         " s after the start: " + forces_in_words(comparison.a, comparison.b, *ticks.first_felt) + ".";
}

std::string account(const Comparison& comparison) {
  const TickComparison& ticks = comparison.ticks;
  std::string text;
  if (ticks.first_felt) text = "Likely cause: " + cause_in_words(comparison.a, comparison.b, *ticks.first_felt) + ". ";
  text += settings_sentence(comparison);
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
