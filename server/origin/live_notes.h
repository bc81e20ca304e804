#pragma once

#include <functional>
#include <string>

#include "messages/playback.pb.h"
#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/origin/resources.h"

namespace telepalp::origin {

/// Moments that people mark while the session takes place, and short words to the others, with a place on the patient.
/// Each becomes a message of /session/notes, so that a recording has it, and all pages show it. Owner: the network thread.
class LiveNotes {
 public:
  using Publish = std::function<void(wire::Message)>;

  explicit LiveNotes(const wire::SessionClock& clock) : clock_(clock) {}
  void start(Publish publish) { publish_ = std::move(publish); }

  /// Carries out the JSON of a msg::MarkCommand of the person `who`. Error: the moment is more than 60 s ago or has not
  /// come yet, the text is too long or has a line break, the place is over 10 m away, or 1000 moments are marked.
  [[nodiscard]] Result<void> mark(const std::string& json, const std::string& who);
  [[nodiscard]] const msg::MarksState& state() const noexcept { return state_; }
  /// The resource /marks. This object must outlive it.
  [[nodiscard]] Resource resource();

 private:
  wire::SessionClock clock_;
  Publish publish_;
  msg::MarksState state_;
};

}  // namespace telepalp::origin
