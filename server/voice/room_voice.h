#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "messages/voice.pb.h"
#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/hub/hub.h"
#include "server/origin/resources.h"
#include "server/voice/alsa/room_loudspeaker.h"
#include "server/voice/alsa/room_microphone.h"
#include "server/voice/spoken_frames.h"
#include "server/voice/voice_floor.h"

namespace telepalp::voice {

/// How `--voice` names the sound of the room.
struct RoomDevice {
  std::string name;      ///< of ALSA
  bool is_open = false;  ///< the microphone, from the start
};
/// Reads alsa[:NAME] or open:alsa[:NAME]. Error: the text has another form.
[[nodiscard]] Result<RoomDevice> room_device(const std::string& text);

/// Microphone and loudspeaker of the patient's room, at the server itself: it publishes /patient/voice while the
/// microphone is open, and plays /doctor/voice. The microphone begins closed. A device that is not there, or is taken
/// away, is tried again every two seconds, and the state says why it is silent. There is no echo canceller: the room
/// needs a headset, or a speakerphone that has one. Owner: the server's network thread; the devices have threads of
/// their own.
class RoomVoice {
 public:
  struct Options {
    std::string device = "default";
    bool is_open = false;                           ///< the microphone, from the start
    std::shared_ptr<VoiceFloor> floor{};            ///< who speaks at the patient's side
    std::function<void(const std::string&)> log{};  ///< log lines for the technician
  };
  RoomVoice(boost::asio::io_context& network, hub::Hub& hub, const wire::SessionClock& clock, Options options);
  /// Ends the threads; it waits for at most a second for each.
  ~RoomVoice();
  RoomVoice(const RoomVoice&) = delete;
  RoomVoice& operator=(const RoomVoice&) = delete;

  void open(bool is_open);
  /// True: a recorded session is shown, into which nobody can speak.
  void session_is_played(bool is_played) noexcept { is_played_ = is_played; }

  [[nodiscard]] const msg::RoomVoiceState& state() const noexcept { return state_; }
  /// The state for visitors, and the command that opens and closes the microphone.
  [[nodiscard]] origin::Resource resource();
  /// Counts as Prometheus text.
  [[nodiscard]] std::string metrics() const;

 private:
  void heard(HeardFrame frame);
  void play_what_came();
  void say_state();
  template <class Act>
  void on_network(Act act);

  boost::asio::io_context& io_;
  hub::Hub& hub_;
  const wire::SessionClock clock_;
  Options options_;
  const std::shared_ptr<bool> lives_ = std::make_shared<bool>(true);  // false for what is posted and runs later
  hub::SubscriberId subscriber_ = 0;
  std::optional<SpokenFrames> frames_;
  msg::RoomVoiceState state_;
  bool is_played_ = false;
  std::uint64_t sent_ = 0;                      // frames
  std::atomic<int> waiting_{0};                 // frames on their way from the microphone's thread
  std::atomic<std::uint64_t> lost_{0};          // frames that the network thread had no time for
  std::optional<RoomLoudspeaker> loudspeaker_;  // last members: their threads use those above
  std::optional<RoomMicrophone> microphone_;
};

}  // namespace telepalp::voice
