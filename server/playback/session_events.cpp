#include "server/playback/session_events.h"

#include <utility>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"

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

SessionEvents::SessionEvents(std::filesystem::path file, SessionTime begin)
    : thread_([this, file = std::move(file), begin] { read(file, begin); }) {}

SessionEvents::~SessionEvents() {
  stopping_ = true;
  thread_.join();
}

msg::SessionEvents SessionEvents::events() const {
  const std::scoped_lock lock(mutex_);
  return events_;
}

void SessionEvents::read(const std::filesystem::path& file, SessionTime begin) {
  read_events(file, begin);
  const std::scoped_lock lock(mutex_);
  events_.set_complete(true);
}

/// A damaged chunk costs only its own events: reading continues after it. SessionPlayer counts the damaged chunks.
void SessionEvents::read_events(const std::filesystem::path& file, SessionTime begin) {
  Result<wire::McapReader> reader = wire::McapReader::open(file);
  if (!reader) return;
  reader->select({.topics = {std::string(wire::kStationEvents.name)}});
  for (int count = 0; count < kMostEvents && !stopping_;) {
    const Result<std::optional<wire::Message>> message = reader->next();
    if (!message) continue;
    if (!*message) return;
    const std::scoped_lock lock(mutex_);
    msg::StationEvent event;
    if (!event.ParseFromString(*(*message)->payload)) continue;
    fill(*events_.add_events(), event, to_seconds((*message)->published - begin));
    ++count;
  }
}

}  // namespace telepalp::playback
