#include "server/origin/reading.h"

#include <boost/asio/post.hpp>
#include <utility>

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kSubscribesWithin{100};  // a page subscribes to its topics one by one
constexpr std::chrono::milliseconds kLooksAgain{1100};       // a paused player repeats its picture once a second

}  // namespace

Reading::Reading(boost::asio::io_context& network, const std::string& session, const Resources& common,
                 std::function<SessionTime()> now)
    : timer_(network), states_(views_, offer_.resources, std::move(now)) {
  state_.set_session(session);
  offer_.resources = common;
  offer_.resources[kReading.topic.name] = {.state = [this] { return state_message(state_); }};
}

void Reading::open(Result<std::unique_ptr<Origin>> origin) {
  if (stopped_) return;
  state_.set_phase(origin ? msg::ReadingState::PHASE_OPEN : msg::ReadingState::PHASE_FAILED);
  if (!origin) return state_.set_problem(to_string(origin.error()));
  origin_ = std::move(origin).value();
  Offer offer = origin_->offer();
  offer_.playback = offer.playback;
  offer_.resources.merge(offer.resources);
  hub_.on_key_frame_request([this](std::string_view topic) {
    if (started_ && !stopped_) origin_->show_again(topic);
  });
  if (awaited_) look();
}

void Reading::subscriptions_changed() {
  if (stopped_) return;
  timer_.expires_after(kSubscribesWithin);
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled && !stopped_) look();
  });
}

/// Starts the origin, or shows its picture to a subscriber that came after its publication.
void Reading::look() {
  awaited_ = true;
  if (!origin_) return;
  if (!std::exchange(started_, true))
    return origin_->start({.on_message = [this](wire::Message message) { hub_.publish(std::move(message)); },
                           .on_end = [] {},
                           .is_wanted = [this](std::string_view topic) { return hub_.is_wanted(topic); }});
  if (!origin_->is_still() || !hub_.is_missed(wire::kCameraDepth.name)) return;
  origin_->show_again(wire::kCameraDepth.name);
  timer_.expires_after(kLooksAgain);
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled && !stopped_) look();
  });
}

void Reading::stop() {
  if (std::exchange(stopped_, true)) return;
  timer_.cancel();
  if (origin_) origin_->stop();
}

/// The last holder's release ends the origin. Its messages that wait in the io_context come before the deletion.
std::shared_ptr<Reading> Readings::made(const ReadingSpec& asked) {
  return {new Reading(network_, asked.session, common_, now_), [&network = network_](Reading* ended) {
            ended->stop();
            boost::asio::post(network, [kept = std::unique_ptr<Reading>(ended)] {});
          }};
}

std::shared_ptr<Reading> Readings::failed(const ReadingSpec& asked, const Error& why) {
  std::shared_ptr<Reading> reading = made(asked);
  reading->open(why);
  return reading;
}

std::shared_ptr<Reading> Readings::join(const std::string& id, const ReadingSpec& asked) {
  std::erase_if(readings_, [](const auto& entry) { return entry.second.expired(); });
  if (std::shared_ptr<Reading> present = find(id)) return present;
  if (!open_)
    return failed(
        asked, {.what = "this server opens no recorded session", .where = id, .fix = "open its page without a moment"});
  if (readings_.size() >= kMost)
    return failed(
        asked, {.what = std::to_string(kMost) + " recorded sessions are open, as many as this server opens at a time",
                .where = asked.session,
                .fix = "close another page that shows a recorded session for one reader"});
  std::shared_ptr<Reading> reading = made(asked);
  readings_[id] = reading;
  open_(
      asked,
      [held = std::weak_ptr(reading)](double share) {
        if (const auto present = held.lock()) present->read_share(share);
      },
      [held = std::weak_ptr(reading)](Result<std::unique_ptr<Origin>> opened) {
        if (const auto present = held.lock()) present->open(std::move(opened));
      });
  return reading;
}

std::shared_ptr<Reading> Readings::find(const std::string& id) const {
  const auto found = readings_.find(id);
  return found == readings_.end() ? nullptr : found->second.lock();
}

}  // namespace telepalp::origin
