#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "messages/camera.pb.h"
#include "messages/playback.pb.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"
#include "server/origin/resources.h"
#include "server/pipeline/wanted.h"

namespace telepalp::origin {

/// Access to a session that is played: reads its state, carries out a command. Both are unset if none is played.
struct PlaybackPort {
  std::function<msg::PlaybackState()> state{};
  std::function<Result<void>(const msg::PlaybackCommand&)> move{};
  [[nodiscard]] explicit operator bool() const noexcept { return state && move; }
};

/// What visitors may see of an origin, and change in it, besides its messages.
struct Offer {
  Resources resources{};
  PlaybackPort playback{};
};

/// Whence messages come: from a camera, or from a recorded session. Owner: the server's network thread.
class Origin {
 public:
  struct Handlers {
    std::function<void(wire::Message)> on_message;  ///< on the network thread
    /// Called instead of on_message for a camera image whose grade is not Full. Only an origin that chooses_content()
    /// has such images.
    std::function<void(wire::Message, plan::Grade)> on_graded{};
    std::function<void()> on_end;                           ///< on the network thread, once, when no more comes
    std::function<bool(std::string_view topic)> is_wanted;  ///< whether somebody has subscribed to the topic
  };

  Origin() = default;
  Origin(const Origin&) = delete;
  Origin& operator=(const Origin&) = delete;
  virtual ~Origin() = default;

  /// Begins to publish.
  virtual void start(Handlers handlers) = 0;
  /// Publishes nothing more; handlers that wait in the io_context may still be called.
  virtual void stop() = 0;

  /// A subscriber cannot decode the predicted messages of `topic` that come next: publishes those from which it can.
  virtual void show_again(std::string_view topic) = 0;
  /// True while no new picture is due, such as in a pause. A newcomer then needs show_again().
  [[nodiscard]] virtual bool is_still() const = 0;

  /// The lease of the touch: true if `topic` is withheld while `stations` stations are connected, so that viewers see
  /// one hand.
  [[nodiscard]] virtual bool withholds(const wire::Topic& topic, std::size_t stations) const = 0;

  /// True if this origin's depth images can be predicted from earlier ones, or not, as let_predict() says.
  [[nodiscard]] virtual bool chooses_prediction() const = 0;
  virtual void let_predict(bool may) = 0;
  /// True if images are made as want() says. False: they are as they were recorded, all of Grade::Full.
  [[nodiscard]] virtual bool chooses_content() const { return false; }
  /// In which codings and grades subscribers want images. Ignored unless chooses_content().
  virtual void want(const pipeline::Wanted& wanted) { (void)wanted; }

  /// Number of depth images so far.
  [[nodiscard]] virtual std::uint64_t images() const = 0;
  /// The state that `status` tells, for the log.
  [[nodiscard]] virtual std::string in_words(const msg::CaptureStatus& status) const = 0;

  /// The functions in it may be called while this object lives.
  [[nodiscard]] virtual Offer offer() { return {}; }
};

}  // namespace telepalp::origin
