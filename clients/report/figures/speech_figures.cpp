#include "clients/report/figures/speech_figures.h"

#include <algorithm>

#include "proto/wire/topics.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"
#include "support/plot/palette.h"

namespace telepalp::report {
namespace {

constexpr double kQuietest_dB = -50.0;  // of speech; such a bar is low, but seen

struct Side {
  std::string_view topic;
  const char* who;
  std::string_view color;
};
constexpr Side kSides[] = {{wire::kPatientVoice.name, "the patient's side", plot::kGreen},
                           {wire::kDoctorVoice.name, "the doctor", plot::kBlue}};

double since_begin_s(const Session& session, SessionTime at) {
  return to_seconds(at - session_time(session.first_ns.value_or(0)));
}

/// Height of a bar, 0 to 1.
double height_of(const speech::Spoken& span) { return std::clamp(1.0 - span.loudest_dB / kQuietest_dB, 0.2, 1.0); }

plot::Chart lane(const Session& session, const Side& side, const std::vector<speech::Spoken>& spans) {
  plot::Series bars{.name = {}, .x = {0.0}, .y = {0.0}, .color = std::string(side.color), .style = plot::Style::Area};
  for (const speech::Spoken& span : spans) {
    bars.x.insert(bars.x.end(), {since_begin_s(session, span.from), since_begin_s(session, span.until)});
    bars.y.insert(bars.y.end(), {height_of(span), 0.0});
  }
  bars.x.push_back(std::max(seconds(session), bars.x.back()));
  bars.y.push_back(0.0);
  return {.title = std::string("speech: ") + side.who,
          .x = {"time [s]"},
          .y = {.label = "", .include = plot::Range{0.0, 1.0}, .ticks = {{0.0, "silent"}, {1.0, "loud"}}},
          .series = {std::move(bars)},
          .height_px = 120.0};
}

template <class Visit>
void for_each_side(const Session& session, Visit visit) {
  for (const Side& side : kSides)
    if (const auto found = session.spoken.find(side.topic); found != session.spoken.end())
      visit(side, found->second.spans);
}

}  // namespace

std::vector<plot::Chart> speech_lanes(const Session& session) {
  std::vector<plot::Chart> lanes;
  for_each_side(session, [&](const Side& side, const auto& spans) { lanes.push_back(lane(session, side, spans)); });
  return lanes;
}

std::string speech_words(const Session& session) {
  std::string words;
  for_each_side(session, [&](const Side& side, const auto& spans) {
    Nanoseconds spoken{};
    for (const speech::Spoken& span : spans) spoken += span.until - span.from;
    words += (words.empty() ? "" : "; ") + std::string(side.who) + " spoke for " + plot::number(to_seconds(spoken), 1) +
             " s, " + counted(spans.size(), "time", "times");
  });
  return words.empty() ? "" : "Of what was said, " + words + ".";
}

}  // namespace telepalp::report
