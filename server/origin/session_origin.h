#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>

#include "proto/wire/session_clock.h"
#include "server/origin/origin.h"
#include "server/origin/played_notes.h"
#include "server/playback/comparison/session_comparison.h"
#include "server/playback/session_events.h"
#include "server/playback/session_network.h"
#include "server/playback/session_notes.h"
#include "server/playback/session_player.h"

namespace telepalp::origin {

/// What is known of a session file as a whole. All that play the file share it, so that no note overwrites another.
struct SessionSurvey {
  playback::SessionEvents events;
  playback::SessionNotes notes;
};

/// A recorded session, played again, with the impaired network that it crosses before it is published.
class SessionOrigin final : public Origin {
 public:
  struct Parts {
    std::unique_ptr<playback::SessionPlayer> player;
    std::shared_ptr<SessionSurvey> survey;
    PlayedNotes said;                                         ///< on the picture, while the session took place
    std::unique_ptr<playback::SessionComparison> comparison;  ///< null: no folder of other sessions is named
    bool is_endless;                                          ///< no visitor can end its repetition
  };
  SessionOrigin(boost::asio::io_context& network, const wire::SessionClock& clock, Parts parts);

  void start(Handlers handlers) override;
  void stop() override;
  void show_again(std::string_view) override { parts_.player->show_again(); }
  [[nodiscard]] bool is_still() const override { return !parts_.player->state().playing(); }
  [[nodiscard]] bool withholds(const wire::Topic& topic, std::size_t stations) const override;
  [[nodiscard]] bool chooses_prediction() const override { return false; }  // its images are as they were recorded
  void let_predict(bool) override {}
  [[nodiscard]] std::uint64_t images() const override { return parts_.player->depth_images(); }
  [[nodiscard]] std::string in_words(const msg::CaptureStatus& status) const override { return status.detail(); }
  [[nodiscard]] Offer offer() override;

 private:
  [[nodiscard]] Result<void> move(msg::PlaybackCommand command);
  [[nodiscard]] Resource playback();

  boost::asio::io_context& io_;
  wire::SessionClock clock_;
  Handlers handlers_;
  playback::SessionNetwork network_;  // between the player and the handlers
  Parts parts_;
};

}  // namespace telepalp::origin
