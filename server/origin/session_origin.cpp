#include "server/origin/session_origin.h"

#include <chrono>
#include <utility>

#include "server/playback/playback_command.h"

namespace telepalp::origin {

SessionOrigin::SessionOrigin(boost::asio::io_context& network, const wire::SessionClock& clock, Parts parts)
    : io_(network),
      clock_(clock),
      network_(network, clock, [this](wire::Message message) { handlers_.on_message(std::move(message)); }),
      parts_(std::move(parts)) {}

void SessionOrigin::start(Handlers handlers) {
  handlers_ = std::move(handlers);
  parts_.player->start(io_, {.on_message =
                                 [this](wire::Message message) {
                                   // A topic without a subscriber, such as the ticks, must not fill an impaired
                                   // network.
                                   if (handlers_.is_wanted(message.topic.name))
                                     network_.send(std::move(message));
                                   else
                                     handlers_.on_message(std::move(message));
                                 },
                             .on_end = [this] { handlers_.on_end(); }});
}

void SessionOrigin::stop() {
  network_.stop();
  parts_.player->stop();
}

bool SessionOrigin::withholds(const wire::Topic& topic, std::size_t stations) const {
  return stations > 0 && topic.publisher == wire::Publisher::Station;
}

Result<void> SessionOrigin::move(msg::PlaybackCommand command) {
  if (const Result<void> valid = playback::check(command); !valid) return valid;
  if (parts_.is_endless) command.clear_loop();
  return parts_.player->apply(command);
}

Resource SessionOrigin::playback() {
  return {.state = [this] { return state_message(parts_.player->state()); },
          .change = at_once([this](const std::string& json, const std::string&) -> Result<void> {
            const Result<msg::PlaybackCommand> command = playback::read_command(json);
            return command ? move(*command) : command.error();
          })};
}

Offer SessionOrigin::offer() {
  Offer offer;
  offer.playback = {.state = [this] { return parts_.player->state(); },
                    .move = [this](const msg::PlaybackCommand& command) { return move(command); }};
  offer.resources[kPlayback.topic.name] = playback();
  offer.resources[kEvents.topic.name] = {.state = [this] { return state_message(parts_.survey->events.events()); }};
  offer.resources[kNetwork.topic.name] = {
      .state = [this] { return state_message(network_.state()); },
      .change = at_once([this](const std::string& json, const std::string&) { return network_.apply(json); })};
  offer.resources[kNotes.topic.name] = {.state = [this] { return state_message(parts_.survey->notes.all()); },
                                        .change = at_once([this](const std::string& json, const std::string& who) {
                                          return parts_.survey->notes.apply(json, who,
                                                                            std::chrono::system_clock::now());
                                        })};
  offer.resources[kMarks.topic.name] = {
      .state = [this] { return state_message(parts_.said.at(parts_.player->state().position_s(), clock_.now())); }};
  if (parts_.comparison)
    offer.resources[kComparison.topic.name] = {.state = [this] { return state_message(parts_.comparison->state()); },
                                               .change = at_once([this](const std::string& json, const std::string&) {
                                                 return parts_.comparison->apply(json);
                                               })};
  return offer;
}

}  // namespace telepalp::origin
