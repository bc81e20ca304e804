#include "server/playback/session_events.h"

#include <algorithm>
#include <utility>

#include "proto/wire/topics.h"
#include "proto/words/counted.h"

namespace telepalp::playback {
namespace {

void fill(msg::SessionEvents::Event& event, const msg::StationEvent& told, double at_s) {
  event.set_at_s(at_s);
  event.set_kind(told.kind());
  event.set_text(told.text());
  event.set_from(told.from());
  event.set_to(told.to());
}

}  // namespace

SessionEvents::SessionEvents(std::filesystem::path file, SessionTime begin, Say say)
    : thread_([this, file = std::move(file), begin, say = std::move(say)] { read(file, begin, say); }) {}

SessionEvents::~SessionEvents() {
  stopping_ = true;
  thread_.join();
}

msg::SessionEvents SessionEvents::events() const {
  const std::scoped_lock lock(mutex_);
  return events_;
}

void SessionEvents::read(const std::filesystem::path& file, SessionTime begin, const Say& say) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  const std::optional<speech::Speech> recorded = reader ? speech::recorded_speech(*reader) : speech::Speech{};
  if (recorded) show(*recorded, begin);
  const LeftOut left_out = reader ? read_events(*reader, begin) : LeftOut{.file = reader.error()};
  const std::string list = "the page's list of events of " + file.filename().string();
  if (left_out.file)
    say(list + " is empty: " + to_string(*left_out.file));
  else if (left_out.damaged > 0)
    say(list + " lacks the events of " + counted(left_out.damaged, "damaged part", "damaged parts") +
        " of the file. fix: telepalp-record verify names the damage");
  else if (left_out.too_many)
    say(list + " ends after " + std::to_string(kMostEvents) + " events. fix: cut the session: telepalp-record cut");
  {
    const std::scoped_lock lock(mutex_);
    events_.set_complete(true);
  }
  if (!recorded) show(speech::surveyed_speech(*reader, [this] { return !stopping_; }), begin);
}

void SessionEvents::show(const speech::Speech& speech, SessionTime begin) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [topic, side] : speech)
    for (const speech::Spoken& span : side.spans) {
      msg::SessionEvents::Speech& told = *events_.add_speech();
      told.set_from_s(std::max(0.0, to_seconds(span.from - begin)));
      told.set_until_s(std::max(0.0, to_seconds(span.until - begin)));
      told.set_doctor(topic == wire::kDoctorVoice.name);
      told.set_loudest_db(span.loudest_dB);
    }
}

/// A damaged chunk costs only its own events: reading continues after it.
SessionEvents::LeftOut SessionEvents::read_events(wire::McapReader& reader, SessionTime begin) {
  LeftOut left_out;
  reader.select({.topics = {std::string(wire::kStationEvents.name)}});
  for (int count = 0; !stopping_;) {
    const Result<std::optional<wire::Message>> message = reader.next();
    msg::StationEvent event;
    const bool is_event = message && *message && event.ParseFromString(*(*message)->payload);
    if (message && !*message) break;
    if (!is_event) {
      ++left_out.damaged;
      continue;
    }
    if (count == kMostEvents) {
      left_out.too_many = true;
      break;
    }
    const std::scoped_lock lock(mutex_);
    fill(*events_.add_events(), event, to_seconds((*message)->published - begin));
    ++count;
  }
  return left_out;
}

}  // namespace telepalp::playback
