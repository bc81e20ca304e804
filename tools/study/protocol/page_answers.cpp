#include "tools/study/protocol/page_answers.h"

#include "support/program/json.h"

namespace telepalp::study {
namespace {

using program::Json;
constexpr double kMm = 1e3;

std::string_view name(Stage stage) {
  constexpr std::string_view kNames[] = {"resting", "ready", "inserting", "finished"};
  return kNames[static_cast<std::size_t>(stage)];
}

void add_pair(Json& json, std::string_view key, const Eigen::Vector2d& value, double unit) {
  json.begin_list(key);
  json.add({}, unit * value.x());
  json.add({}, unit * value.y());
  json.end_list();
}

void add_last(Json& json, const Session& session) {
  if (!session.last()) return json.add_null("last");
  const Outcome& out = session.last()->trial.outcome;
  json.begin_object("last");
  json.add("what", name(session.last()->kind));
  json.add("through", out.through);
  json.add("stopped", out.stopped);
  json.add("overshoot", kMm * out.overshoot_m);
  json.end_object();
}

std::string object(std::string_view kind, const auto& add) {
  Json json;
  json.begin_object();
  json.add("kind", kind);
  add(json);
  json.end_object();
  return std::move(json).finish();
}

/// Links of another mechanism than a four-bar linkage: both ends of each.
void add_links(Json& json, const MechanismPicture& at) {
  json.begin_list("links");
  for (std::size_t i = 0; i < at.count; ++i) {
    json.begin_list({});
    for (const Eigen::Vector2d& end : at.links[i]) add_pair(json, {}, end, kMm);
    json.end_list();
  }
  json.end_list();
}

/// Places outside the skin: of the needle, only the part above it.
void add_seen(Json& json, const TrialView& trial) {
  const MechanismPicture& at = trial.picture;
  json.begin_object("seen");
  if (at.four_bar)
    for (const auto& [key, place] :
         {std::pair{"a", at.four_bar->a_m}, {"o", at.four_bar->o_m}, {"b", at.four_bar->b_m}, {"d", at.four_bar->d_m}})
      add_pair(json, key, place, kMm);
  else
    add_links(json, at);
  add_pair(json, "c", at.hand_m, kMm);
  add_pair(json, "p", at.needle_m, kMm);
  const bool hidden = trial.through_skin && at.tip_m.y() < 0.0 && at.needle_m.y() > 0.0;
  const double share = hidden ? at.needle_m.y() / (at.needle_m.y() - at.tip_m.y()) : 1.0;
  add_pair(json, "end", at.needle_m + share * (at.tip_m - at.needle_m), kMm);
  json.add("through_skin", hidden);
  json.end_object();
}

}  // namespace

std::string state_json(const Session& session, const std::string& participant) {
  return object("state", [&](Json& json) {
    const Planned& planned = session.planned();
    json.add("participant", participant);
    json.add("stage", name(session.stage()));
    json.add("done", static_cast<std::uint64_t>(session.done()));
    json.add("all", static_cast<std::uint64_t>(session.all()));
    json.add("training", planned.training);
    json.add("condition", name(planned.condition));
    json.add("device", session.hand() == PersonHand::Device);
    json.add("sees", sees_needle(planned.condition));
    json.add("feels", feels(planned.condition));
    json.add("mechanism", static_cast<std::uint64_t>(planned.place + 1));
    json.add("mechanisms", static_cast<std::uint64_t>(session.mechanisms()));
    json.add("penetration", static_cast<std::uint64_t>(planned.penetration + 1));
    add_last(json, session);
  });
}

std::string trial_frame_json(const TrialView& trial, Condition condition) {
  return object("frame", [&](Json& json) {
    add_pair(json, "along", trial.along, 1.0);
    if (sees_needle(condition)) add_seen(json, trial);
    if (feels(condition)) json.add("hand_N", trial.needle_N);
  });
}

std::string page_refused_json(const Error& error) {
  return object("refused", [&](Json& json) {
    json.add("what", error.what);
    json.add("fix", error.fix);
  });
}

std::string taken_json() {
  return object("taken", [](Json&) {});
}

}  // namespace telepalp::study
