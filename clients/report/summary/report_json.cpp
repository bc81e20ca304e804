#include "clients/report/summary/report_json.h"

#include "clients/ar/messages/phases.h"
#include "clients/report/summary/provenance.h"
#include "support/program/json.h"

namespace telepalp::report {
namespace {

using program::Json;

void add_quantiles(Json& json, std::string_view key, const Quantiles& values, bool tail) {
  json.begin_object(key);
  json.add("p50", values.p50);
  json.add("p99", values.p99);
  if (tail) {
    json.add("p999", values.p999);
    json.add("max", values.most);
  }
  json.end_object();
}

void add_latencies(Json& json, const Summary& summary) {
  json.begin_object("latency_ms");
  add_quantiles(json, "capture_to_encoded", summary.capture_to_encoded_ms, false);
  add_quantiles(json, "encoded_to_received", summary.encoded_to_received_ms, false);
  add_quantiles(json, "received_to_decoded", summary.received_to_decoded_ms, false);
  add_quantiles(json, "decoded_to_touchable", summary.decoded_to_touchable_ms, false);
  add_quantiles(json, "capture_to_touchable", summary.capture_to_touchable_ms, false);
  json.end_object();
  add_quantiles(json, "surface_age_ms", summary.surface_age_ms, false);
  add_quantiles(json, "clock_error_ms", summary.clock_error_ms, false);
  add_quantiles(json, "surface_carried_mm", summary.surface_carried_mm, false);
  add_quantiles(json, "hand_carried_mm", summary.hand_carried_mm, false);
  json.add("unmodelled_share", summary.unmodelled_share);
  json.add("object_unseen_share", summary.object_unseen_share);
  json.add("object_slide_unseen_share", summary.object_slide_unseen_share);
}

void add_states(Json& json, const Summary& summary) {
  json.begin_object("states");
  for (std::size_t i = 0; i < ar::kPhases.size(); ++i) {
    json.begin_object(ar::kPhases[i].key);
    json.add("entries", summary.dwells[i].entries);
    json.add("seconds", summary.dwells[i].seconds);
    json.end_object();
  }
  json.end_object();
}

void add_bill(Json& json, const Summary& summary) {
  json.begin_list("bill");
  for (const msg::EffectCost& cost : summary.bill) {
    json.begin_object();
    json.add("name", cost.name());
    json.add("mean_us", cost.mean_us());
    json.add("max_us", cost.max_us());
    json.end_object();
  }
  json.end_list();
}

void add_count(Json& json, std::string_view key, const std::optional<std::uint64_t>& count) {
  if (count)
    json.add(key, *count);
  else
    json.add_null(key);
}

void add_senders(Json& json, const Summary& summary) {
  json.begin_list("senders");
  for (const SenderSummary& sender : summary.senders) {
    json.begin_object();
    json.add("sender", std::uint64_t{sender.sender});
    json.add("name", sender.name);
    json.add("address", sender.address);
    json.add("messages", sender.messages);
    json.add("ticks", sender.ticks);
    json.add("touches", sender.touches);
    json.add("force_max_N", sender.force_max_N);
    json.begin_object("frames");
    add_count(json, "sent", sender.frames_sent);
    add_count(json, "received", sender.frames_received);
    add_count(json, "dropped", sender.frames_dropped);
    json.end_object();
    json.end_object();
  }
  json.end_list();
}

void add_idle_timer(Json& json, const Summary& summary) {
  if (!summary.idle_timer) return json.add_null("idle_timer");
  json.begin_object("idle_timer");
  json.add("wakeups", summary.idle_timer->wakeups);
  json.add("missed", summary.idle_timer->missed);
  json.end_object();
}

void add_ways(Json& json, const Summary& summary) {
  json.begin_list("ways");
  for (const Way& way : summary.ways) {
    json.begin_object();
    json.add("from_s", way.from_s);
    json.add("way", way.words);
    json.end_object();
  }
  json.end_list();
}

void add_notes(Json& json, const Session& session) {
  json.begin_list("notes");
  for (const msg::SessionNotes::Note& note : session.notes.notes()) {
    json.begin_object();
    json.add("at_s", note.at_s());
    json.add("text", note.text());
    json.add("who", note.who());
    json.add("written", note.written());
    json.end_object();
  }
  json.end_list();
}

void add_text_or_null(Json& json, std::string_view key, const std::string& text) {
  if (text.empty())
    json.add_null(key);
  else
    json.add(key, text);
}

void add_provenance(Json& json, const Provenance& from) {
  json.add("notice", kNotAMedicalDevice);
  add_text_or_null(json, "date", from.date);
  add_text_or_null(json, "scene", from.scene);
  add_text_or_null(json, "software", from.software);
  add_text_or_null(json, "server_software", from.server);
  add_text_or_null(json, "station_software", from.station);
  add_text_or_null(json, "recorded_by", from.recorder);
  add_text_or_null(json, "consent", from.consent);
}

void add_verdict(Json& json, const Verdict& verdict) {
  json.begin_object("verdict");
  json.add("good", verdict.good);
  json.add("headline", verdict.headline);
  json.begin_list("causes");
  for (const Cause& cause : verdict.causes) {
    json.begin_object();
    json.add("what", cause.what);
    json.add("to_do", cause.to_do);
    add_text_or_null(json, "when", cause.when);
    json.end_object();
  }
  json.end_list();
  json.begin_list("checks");
  for (const Check& check : verdict.checks) {
    json.begin_object();
    json.add("name", check.name);
    json.add("value", check.value);
    json.add(check.at_most ? "at_most" : "at_least", check.budget);
    json.add("unit", check.unit);
    if (check.standing() == Standing::NotMeasured)
      json.add_null("holds");
    else
      json.add("holds", check.standing() == Standing::Holds);
    json.end_object();
  }
  json.end_list();
  json.end_object();
}

/// What the hand felt: contacts, forces, indentation, and the energy that the display gave.
void add_touches(Json& json, const Summary& summary) {
  json.add("touches", summary.touches);
  json.add("contact_s", summary.contact_s);
  json.begin_object("force_N");
  json.add("max", summary.force_max_N);
  json.add("max_in_contact", summary.force_in_contact_max_N);
  json.add("max_of_drive", summary.force_of_drive_max_N);
  json.end_object();
  json.begin_object("indentation_mm");
  json.add("max", summary.indentation_max_mm);
  json.end_object();
  json.begin_object("energy_mJ");
  json.add("display_least", summary.display_least_mJ);
  json.add("hand_excess_most", summary.hand_excess_most_mJ);
  json.end_object();
}

}  // namespace

std::string report_json(const Session& session, const Summary& summary, const Verdict& verdict) {
  Json json;
  json.begin_object();
  json.add("session", session.name);
  json.add("source", source_of(session));
  json.add("recorded_from", session.origin);
  add_provenance(json, provenance_of(session));
  json.add("seconds", summary.seconds);
  json.add("ticks", summary.ticks);
  add_quantiles(json, "tick_us", summary.tick_us, true);
  add_quantiles(json, "lateness_us", summary.lateness_us, true);
  json.add("deadlines_missed", summary.deadlines_missed);
  json.add("telemetry_dropped", summary.telemetry_dropped);
  json.add("ticks_missing", summary.ticks_missing);
  if (summary.realtime)
    json.add("realtime", *summary.realtime);
  else
    json.add_null("realtime");
  json.begin_object("frames");
  json.add("sent", summary.frames_sent);
  json.add("received", summary.frames_received);
  json.add("dropped", summary.frames_dropped);
  json.add("on_the_way", summary.frames_on_the_way);
  json.add("unused", summary.frames_unused);
  json.end_object();
  json.add("depth_mode", summary.depth.mode);
  if (summary.depth.within) {
    json.begin_object("depth_bound_mm");
    json.add("least", 1e3 * summary.depth.within->least_m);
    json.add("per_m2", 1e3 * summary.depth.within->per_m);
    json.end_object();
  } else {
    json.add_null("depth_bound_mm");
  }
  json.begin_object("rates_per_s");
  json.add("camera_depth", summary.camera_depth_per_s);
  json.add("camera_color", summary.camera_color_per_s);
  json.add("ticks", summary.ticks_per_s);
  json.add("station_state", summary.states_per_s);
  json.end_object();
  add_latencies(json, summary);
  add_states(json, summary);
  add_touches(json, summary);
  json.add("heat_warnings", summary.heat_warnings);
  json.add("non_finite", summary.non_finite);
  json.add("damaged_messages", summary.damaged_messages);
  add_idle_timer(json, summary);
  add_senders(json, summary);
  add_ways(json, summary);
  add_bill(json, summary);
  add_notes(json, session);
  add_verdict(json, verdict);
  json.end_object();
  return std::move(json).finish();
}

}  // namespace telepalp::report
