#pragma once

#include <cstddef>
#include <vector>

#include "messages/playback.pb.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/words/time.h"

namespace telepalp::origin {

/// What people said on the picture while a played session took place, with the places that they pointed at: shown again
/// at its moment, after a seek too. Pure. Owner: the network thread.
class PlayedNotes {
 public:
  /// How long a note is shown, of the session's time. A page shows it as long, of its own.
  static constexpr Nanoseconds kStands = std::chrono::seconds(20);

  /// `notes`: as wire::told_notes() gives them. Marks with neither words nor a place are left out.
  explicit PlayedNotes(std::vector<wire::ToldNote> notes);

  /// The notes at `position_s` of the session, at most the four newest. `now`: of the receivers' clock. A note's time
  /// is the one at which it appeared on that clock; in a paused session it is renewed, so that pages do not take it
  /// away.
  [[nodiscard]] const msg::MarksState& at(double position_s, SessionTime now);

 private:
  std::vector<wire::ToldNote> notes_;
  std::vector<std::size_t> shown_;  // places in notes_ of those in state_
  msg::MarksState state_;
};

}  // namespace telepalp::origin
