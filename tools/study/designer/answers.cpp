#include "tools/study/designer/answers.h"

#include <span>

#include "support/program/json.h"

namespace telepalp::study {
namespace {

using program::Json;
constexpr double kMm = 1e3;

void add_pair(Json& json, std::string_view key, const Eigen::Vector2d& value, double unit = 1.0) {
  json.begin_list(key);
  json.add({}, unit * value.x());
  json.add({}, unit * value.y());
  json.end_list();
}

void add_trace(Json& json, const std::vector<TracePoint>& trace) {
  json.begin_list("trace");
  for (const TracePoint& point : trace) {
    json.begin_list({});
    json.add({}, kMm * point.depth_m);
    json.add({}, point.needle_N);
    json.add({}, point.hand_N);
    json.end_list();
  }
  json.end_list();
}

std::string_view name(tissue::LayerState state) {
  constexpr std::string_view kNames[] = {"outside", "touching", "inside"};
  return kNames[static_cast<std::size_t>(state)];
}

constexpr std::string_view kLayers[] = {"skin", "muscle", "sac"};  // of tissue_of()

void add_layers(Json& json, const LiveFrame& frame) {
  json.begin_object("layers");
  for (std::size_t i = 0; i < frame.layers.size(); ++i) json.add(kLayers[i], name(frame.layers[i]));
  json.end_object();
}

void add_punctures(Json& json, const LiveFrame& frame) {
  json.begin_list("punctures");
  for (const Puncture& puncture : std::span(frame.punctures).first(frame.punctured)) {
    json.begin_object();
    json.add("layer", kLayers[puncture.layer]);
    json.add("depth", kMm * puncture.depth_m);
    json.add("before", puncture.before_N);
    json.add("after", puncture.after_N);
    json.end_object();
  }
  json.end_list();
}

void add_part(Json& json, std::string_view key, const std::optional<mechanism::LinkPart>& part) {
  if (part)
    json.add(key, mechanism::name(*part));
  else
    json.add_null(key);
}

void add_frame(Json& json, const LiveFrame& frame, const std::vector<TracePoint>& trace) {
  for (const auto& [key, place] : {std::pair{"a", frame.at.a_m},
                                   {"o", frame.at.o_m},
                                   {"b", frame.at.b_m},
                                   {"p", frame.at.p_m},
                                   {"d", frame.at.d_m},
                                   {"c", frame.at.c_m},
                                   {"tip", frame.at.tip_m},
                                   {"grasp", frame.grasp_m}})
    add_pair(json, key, place, kMm);
  json.add("link3", frame.link3_rad);
  json.add("dead_point", frame.at_dead_point);
  add_pair(json, "needle_N", frame.needle_N);
  add_pair(json, "hand_N", frame.hand_N);
  add_pair(json, "contact_N", frame.contact_N);
  add_part(json, "held", frame.held);
  add_part(json, "touched", frame.touched);
  add_layers(json, frame);
  add_punctures(json, frame);
  add_trace(json, trace);
}

void add_reach(Json& json, const Reach& reach) {
  json.add("grashof", mechanism::name(reach.grashof));
  json.add("whole_turn", reach.range.whole_turn);
  json.begin_list("reach");
  for (const ReachPoint& point : reach.points) {
    json.begin_list({});
    for (const double value : {point.link3_rad, kMm * point.hand_m.x(), kMm * point.hand_m.y(), kMm * point.tip_m.x(),
                               kMm * point.tip_m.y(), point.hand_N})
      json.add({}, value);
    json.end_list();
  }
  json.end_list();
}

void add_interval(Json& json, std::string_view key, const Interval& interval) {
  json.begin_list(key);
  for (const double value : {interval.mean, interval.low, interval.high}) json.add({}, value);
  json.end_list();
}

void add_judgement(Json& json, const Judgement& judgement) {
  add_interval(json, "overshoot", judgement.overshoot_mm);
  add_interval(json, "hand", judgement.hand_N);
  json.add("noticed", judgement.noticed_share);
  json.add("failed", static_cast<std::uint64_t>(judgement.failed));
  json.add("operators", static_cast<std::uint64_t>(judgement.overshoots_mm.size()));
}

/// The parameters in the text's units; those that are drawn for each operator are null.
void add_design(Json& json, const Configuration& design) {
  json.begin_object("design");
  for (const MechanismParameter& parameter : mechanism_parameters()) {
    const bool drawn =
        (parameter.name == "l4" && !design.l4_given) || (parameter.name == "needle" && !design.needle_given);
    if (drawn)
      json.add_null(parameter.name);
    else
      json.add(parameter.name, design.bar.*parameter.value / parameter.unit);
  }
  json.end_object();
}

void add_searched(Json& json, std::string_view key, const std::vector<SearchedDesign>& designs) {
  json.begin_list(key);
  for (const SearchedDesign& one : designs) {
    if (!one.searched.feasible()) continue;
    json.begin_object();
    json.add("name", one.mechanism.name);
    add_design(json, one.mechanism);
    add_judgement(json, one.searched);
    if (one.held_out) add_interval(json, "held_out", one.held_out->overshoot_mm);
    json.end_object();
  }
  json.end_list();
}

std::string object(std::string_view kind, const auto& add) {
  Json json;
  json.begin_object();
  json.add("kind", kind);
  add(json);
  json.end_object();
  return std::move(json).finish();
}

}  // namespace

std::string design_json(const LiveFrame& frame, const mechanism::FourBar& bar, const Reach& reach,
                        const std::vector<TracePoint>& trace) {
  return object("design", [&](Json& json) {
    json.add("sac_depth", kMm * Plant{}.sac_depth_m);
    json.add("sac_link3", Plant{}.link3_rad);
    json.add("needle", kMm * bar.needle_m);
    add_reach(json, reach);
    json.begin_object("frame");
    add_frame(json, frame, trace);
    json.end_object();
  });
}

std::string frame_json(const LiveFrame& frame, const std::vector<TracePoint>& trace) {
  return object("frame", [&](Json& json) { add_frame(json, frame, trace); });
}

std::string device_json(bool ours, std::string_view trouble) {
  return object("device", [&](Json& json) {
    json.add("ours", ours);
    json.add("trouble", trouble);
  });
}

std::string refused_json(std::string_view of, const Error& error) {
  return object("refused", [&](Json& json) {
    json.add("of", of);
    json.add("what", error.what);
    json.add("fix", error.fix);
  });
}

std::string predicting_json(int done, int all) {
  return object("predicting", [&](Json& json) {
    json.add("done", static_cast<std::uint64_t>(done));
    json.add("all", static_cast<std::uint64_t>(all));
  });
}

std::string prediction_json(const Judgement& judgement) {
  return object("prediction", [&](Json& json) { add_judgement(json, judgement); });
}

std::string searching_json(const SearchState& state) {
  return object("searching", [&](Json& json) {
    json.add("held_out", state.held_out);
    json.add("done", static_cast<std::uint64_t>(state.done));
    json.add("all", static_cast<std::uint64_t>(state.total));
    add_searched(json, "front", state.front);
  });
}

std::string found_json(const SearchResult& result) {
  return object("found", [&](Json& json) {
    json.add("stopped", result.stopped);
    add_searched(json, "front", result.front);
    add_searched(json, "paper", result.paper);
  });
}

}  // namespace telepalp::study
