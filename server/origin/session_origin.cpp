#include "server/origin/session_origin.h"

#include <chrono>
#include <utility>

#include "server/playback/playback_command.h"
#include "support/program/message_json.h"

namespace telepalp::origin {

SessionOrigin::SessionOrigin(boost::asio::io_context& network, const wire::SessionClock& clock, Parts parts)
    : io_(network),
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
  return {.state = [this] { return program::to_json(parts_.player->state()); },
          .change = [this](const std::string& json, const std::string&) -> Result<std::string> {
            const Result<msg::PlaybackCommand> command = playback::read_command(json);
            if (!command) return command.error();
            if (const Result<void> moved = move(*command); !moved) return moved.error();
            return program::to_json(parts_.player->state());
          }};
}

/// Without a folder of other sessions the state is empty, because a browser would log a missing page as an error.
Resource SessionOrigin::comparison() {
  if (!parts_.comparison)
    return {.state = [] { return std::string("{}"); },
            .change = [](const std::string&, const std::string&) -> Result<std::string> {
              return Error{.what = "this server compares no sessions",
                           .where = "playback/comparison",
                           .fix = "start telepalp-server with --compare-dir DIR"};
            }};
  return {.state = [this] { return parts_.comparison->json(); },
          .change = [this](const std::string& json, const std::string&) { return parts_.comparison->apply(json); }};
}

Offer SessionOrigin::offer() {
  Offer offer;
  offer.playback = {.state = [this] { return parts_.player->state(); },
                    .move = [this](const msg::PlaybackCommand& command) { return move(command); }};
  offer.resources[kPlaybackPath] = playback();
  offer.resources[kComparisonPath] = comparison();
  offer.resources[kEventsPath] = {.state = [this] { return program::to_json(parts_.survey->events.events()); }};
  offer.resources[kNetworkPath] = {
      .state = [this] { return network_.state(); },
      .change = [this](const std::string& json, const std::string&) { return network_.apply(json); }};
  offer.resources[kNotesPath] = {.state = [this] { return parts_.survey->notes.json(); },
                                 .change =
                                     [this](const std::string& json, const std::string& who) {
                                       return parts_.survey->notes.apply(json, who, std::chrono::system_clock::now());
                                     }};
  return offer;
}

}  // namespace telepalp::origin
