#include "server/voice/room_voice.h"

#include <boost/asio/post.hpp>
#include <utility>

#include "proto/wire/topics.h"
#include "proto/wire/voice/voice_message.h"
#include "support/program/message_json.h"
#include "support/program/text/metric_text.h"
#include "support/speech/voice_packets.h"

namespace telepalp::voice {
namespace {

constexpr int kMostWaiting = 25;  // frames; half a second, after which the network thread is too busy to speak

Result<bool> read_open(const std::string& json) {
  constexpr const char* kExample = "send JSON such as {\"open\": true}";
  msg::RoomVoiceCommand command;
  if (const Result<void> read = program::read_json(json, command, "room_voice", kExample); !read) return read.error();
  if (command.has_open()) return command.open();
  return Error{.what = "the command says nothing", .where = "room_voice", .fix = kExample};
}

}  // namespace

Result<RoomDevice> room_device(const std::string& text) {
  constexpr std::string_view kOpen = "open:";
  constexpr std::string_view kNamed = "alsa:";
  const bool is_open = text.starts_with(kOpen);
  const std::string device = is_open ? text.substr(kOpen.size()) : text;
  if (device == "alsa") return RoomDevice{.name = "default", .is_open = is_open};
  if (device.starts_with(kNamed) && device.size() > kNamed.size())
    return RoomDevice{.name = device.substr(kNamed.size()), .is_open = is_open};
  return Error{.what = "'" + text + "' is not a way to hear the room",
               .where = "--voice",
               .fix = "give alsa, alsa:NAME with a name that arecord -L lists, or open:alsa:NAME to begin unmuted"};
}

RoomVoice::RoomVoice(boost::asio::io_context& network, hub::Hub& hub, const wire::SessionClock& clock, Options options)
    : io_(network), hub_(hub), clock_(clock), options_(std::move(options)) {
  state_.set_device(options_.device);
  state_.set_open(options_.is_open);
  subscriber_ = hub_.join("room", "alsa:" + options_.device, [this] { on_network([this] { play_what_came(); }); });
  hub_.subscribe(subscriber_, {std::string(wire::kDoctorVoice.name)});
  frames_.emplace(subscriber_);
  loudspeaker_.emplace(options_.device, clock_, [this](const std::string& problem) {
    on_network([this, problem] {
      state_.set_loudspeaker_problem(problem);
      options_.log(problem.empty() ? "the loudspeaker of the room plays" : "the loudspeaker of the room: " + problem);
    });
  });
  microphone_.emplace(options_.device, options_.is_open, clock_,
                      RoomMicrophone::Handlers{.on_heard =
                                                   [this](HeardFrame frame) {
                                                     if (waiting_ >= kMostWaiting) {
                                                       ++lost_;
                                                       return;
                                                     }
                                                     ++waiting_;
                                                     on_network([this, frame = std::move(frame)]() mutable {
                                                       heard(std::move(frame));
                                                     });
                                                   },
                                               .on_state =
                                                   [this](bool hears, const std::string& problem) {
                                                     on_network([this, hears, problem] {
                                                       state_.set_hears(hears);
                                                       state_.set_microphone_problem(problem);
                                                       say_state();
                                                     });
                                                   }});
}

RoomVoice::~RoomVoice() {
  *lives_ = false;
  microphone_->stop();
  loudspeaker_->stop();
  options_.floor->leave(subscriber_);
  hub_.leave(subscriber_);
}

/// Runs `act` on the network thread, unless this object is gone by then.
template <class Act>
void RoomVoice::on_network(Act act) {
  boost::asio::post(io_, [lives = lives_, act = std::move(act)]() mutable {
    if (*lives) act();
  });
}

void RoomVoice::say_state() {
  const std::string& problem = state_.microphone_problem();
  if (state_.hears())
    options_.log("the microphone of the room is open");
  else if (!problem.empty())
    options_.log("the microphone of the room: " + problem);
  else
    options_.log("the microphone of the room is closed");
}

void RoomVoice::open(bool is_open) {
  state_.set_open(is_open);
  if (!is_open) state_.clear_microphone_problem();
  microphone_->open(is_open);
}

void RoomVoice::heard(HeardFrame frame) {
  --waiting_;
  const SessionTime now = clock_.now();
  if (!state_.open() || is_played_ || !options_.floor->speaks(subscriber_, now)) return;
  ++sent_;
  hub_.publish(frames_->message_of(std::move(frame), now));
}

void RoomVoice::play_what_came() {
  while (const std::optional<wire::Message> message = hub_.next(subscriber_))
    if (const auto frame = wire::read_voice_frame(*message->payload)) loudspeaker_->add(speech::packets_of(*frame));
}

origin::Resource RoomVoice::resource() {
  return {.state = [this] { return origin::state_message(state_); },
          .change = origin::at_once([this](const std::string& json, const std::string&) -> Result<void> {
            const Result<bool> wanted = read_open(json);
            if (!wanted) return wanted.error();
            open(*wanted);
            return {};
          })};
}

std::string RoomVoice::metrics() const {
  const codec::VoicePlayout::Counts played = loudspeaker_->counts();
  return program::metric_text("telepalp_room_microphone_open", "gauge",
                              "1 while the microphone in the patient's room is open, else 0.", state_.hears() ? 1 : 0) +
         program::metric_text(
             "telepalp_room_voice_problems", "gauge", "Sound devices of the room that cannot be used now.",
             (state_.microphone_problem().empty() ? 0U : 1U) + (state_.loudspeaker_problem().empty() ? 0U : 1U)) +
         program::metric_text("telepalp_room_voice_frames_sent_total", "counter",
                              "20 ms frames of the room's microphone that were published.", sent_) +
         program::metric_text("telepalp_room_voice_frames_lost_total", "counter",
                              "20 ms frames of the room's microphone that the server had no time to publish.", lost_) +
         program::metric_text("telepalp_room_voice_frames_played_total", "counter",
                              "20 ms frames of the doctor's voice that the room heard.",
                              played.played + played.restored) +
         program::metric_text("telepalp_room_voice_frames_concealed_total", "counter",
                              "20 ms frames of the doctor's voice that were lost or late.", played.concealed) +
         program::metric_text("telepalp_room_voice_breaks_total", "counter",
                              "Times that a sound device of the room lost sound, or had none.",
                              microphone_->breaks() + loudspeaker_->breaks());
}

}  // namespace telepalp::voice
