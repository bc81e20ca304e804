#include "server/server.h"

#include <malloc.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <cstdio>
#include <string_view>
#include <utility>

#include "messages/camera.pb.h"
#include "messages/clock.pb.h"
#include "proto/wire/camera/depth_window_message.h"
#include "server/hub/server_stats.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

constexpr auto kContentEvery = 200ms;

bool is_depth(std::string_view topic) {
  return topic == wire::kCameraDepth.name || topic == wire::kCameraDepthWindow.name;
}

const Error kAnEdge{.what = "this server is an edge, which shows what another server publishes, and takes no stations",
                    .where = {},
                    .fix = "connect the station to the server at the patient's site"};

msg::Clock clock_message(SessionTime now) {
  const auto utc = std::chrono::system_clock::now().time_since_epoch();
  msg::Clock clock;
  clock.set_session_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  clock.set_utc_ns(static_cast<std::uint64_t>(std::chrono::duration_cast<Nanoseconds>(utc).count()));
  return clock;
}

}  // namespace

Result<std::unique_ptr<Server>> Server::listen(boost::asio::io_context& io, Options options) {
  std::unique_ptr<Server> server(new Server(io, std::move(options)));
  auto listener = hub::PeerListener::listen(
      io, server->hub_, server->clock_,
      {.address = server->options_.bind,
       .port = server->options_.port,
       .name = server->options_.name,
       .access = server->options_.access,
       .no_stations = server->options_.clock_upstream ? std::optional(kAnEdge) : std::nullopt,
       .on_note = [raw = server.get()](const std::string& text) { raw->log(text); },
       .on_window = [raw = server.get()](const msg::WindowRequest& request) { raw->follow_window(request); },
       .relays = server->options_.relays,
       // The statistics are published before the hub forgets the totals of a leaving peer.
       .on_leaving = [raw = server.get()] { raw->publish_clock_and_stats(); }});
  if (!listener) return listener.error();
  server->listener_ = std::move(listener).value();
  return server;
}

Server::Server(boost::asio::io_context& io, Options options)
    : io_(io),
      options_(std::move(options)),
      clock_(options_.clock_upstream.value_or(wire::SessionClock::anchored_to_wall_clock())),
      window_(options_.access->has_keys()),
      second_(io),
      content_timer_(io) {
  if (options_.clock_upstream) hub_.keep_numbers();
  hub_.on_key_frame_request([this](std::string_view topic) {
    if (origin_) origin_->show_again(topic);
  });
}

void Server::start(std::unique_ptr<origin::Origin> origin, std::function<void()> on_end) {
  started_ = std::chrono::steady_clock::now();
  on_end_ = std::move(on_end);
  run_origin(std::move(origin));
  publish_every_second();
  choose_content_often();
}

/// Drops the messages that a replaced origin has already posted to the io_context.
void Server::run_origin(std::unique_ptr<origin::Origin> origin) {
  shown_since_ = std::chrono::steady_clock::now();
  origin_ = std::move(origin);
  const auto is_present = [this, present = origin_.get()] { return origin_.get() == present; };
  origin_->start({.on_message =
                      [this, is_present](wire::Message message) {
                        if (is_present()) publish(std::move(message));
                      },
                  .on_graded =
                      [this, is_present](wire::Message message, plan::Grade grade) {
                        if (is_present()) publish(std::move(message), grade);
                      },
                  .on_end =
                      [this, is_present] {
                        if (is_present()) on_end_();
                      },
                  .is_wanted = [this](std::string_view topic) { return hub_.is_wanted(topic); }});
  if (origin_->chooses_prediction()) origin_->let_predict(predicts_);
}

void Server::replace(std::unique_ptr<origin::Origin> origin) {
  if (stopped_) return;
  origin_->stop();
  boost::asio::post(io_, [ended = std::move(origin_)] {});  // after the messages that it has posted
  run_origin(std::move(origin));
}

void Server::stop(const std::string& reason) {
  stopped_ = true;
  if (origin_) origin_->stop();
  second_.cancel();
  content_timer_.cancel();
  publish_clock_and_stats();
  listener_->close(reason);
}

void Server::publish(wire::Message message, plan::Grade grade) {
  if (origin_->withholds(message.topic, listener_->stations())) return;
  if (message.topic.name == wire::kCameraStatus.name) log_state_changes(message);
  if (is_depth(message.topic.name)) {
    last_depth_ = std::chrono::steady_clock::now();
    tell_origin_what_is_wanted();
  }
  content_.published(message, grade);
  hub_.publish(std::move(message), grade);
}

void Server::tell_origin_what_is_wanted() {
  const auto wanted = [&](plan::Grade grade) {
    const auto wants = [&](const wire::Topic& topic) { return hub_.is_wanted(topic.name, grade); };
    return pipeline::GradeWanted{
        .color = {.pictures = wants(wire::kCameraColor), .video = wants(wire::kCameraColorVideo)},
        .depth = {.whole = wants(wire::kCameraDepth), .window = wants(wire::kCameraDepthWindow)},
        .settings = content_.plan().settings[plan::index_of(grade)]};
  };
  const pipeline::GradeWanted full = wanted(plan::Grade::Full);
  origin_->want({.color = full.color,
                 .depth = full.depth,
                 .window = window_.at(clock_.now()),
                 .touch = wanted(plan::Grade::Touch),
                 .view = wanted(plan::Grade::View),
                 .given_up = content_.given_up()});
}

void Server::follow_window(const msg::WindowRequest& request) {
  const std::optional<DepthWindow> window = wire::window_of(request.window());
  if (!window || !origin_) return;
  if (window_.ask(request.sender(), *window, clock_.now())) return tell_origin_what_is_wanted();
  if (!std::exchange(window_noted_, true))
    log("a second station asks for exact depth around its hand: images are exact around the hand of the station that "
        "asked first, until that station has not asked for 1 s");
}

std::string Server::problem() const {
  if (origin_ && origin_->is_still()) return "";
  constexpr std::chrono::seconds kLongest{5};
  const auto since = std::max(last_depth_, shown_since_);
  return std::chrono::steady_clock::now() - since > kLongest
             ? "no depth image arrived for 5 s. fix: check the camera or the recording, and read the server's log"
             : "";
}

void Server::publish_every_second() {
  publish_clock_and_stats();
  show_newcomers_the_picture();
  give_memory_back();
  choose_prediction();
  second_.expires_after(1s);
  second_.async_wait([this](const boost::system::error_code& stopped) {
    if (!stopped && !stopped_) publish_every_second();
  });
}

/// Repeats a picture that stands still for a subscriber that came after its publication.
void Server::show_newcomers_the_picture() {
  if (origin_->is_still() && hub_.is_missed(wire::kCameraDepth.name)) origin_->show_again(wire::kCameraDepth.name);
}

void Server::publish_clock_and_stats() {
  const SessionTime now = clock_.now();
  hub_.publish(wire::make_message(wire::kClock, now, clock_message(now)));
  listener_->note_shares();
  msg::ServerStats stats = hub::server_stats(hub_, datagram_counts(), now);
  stats.set_software(options_.software);
  hub_.publish(wire::make_message(wire::kServerStats, now, stats));
}

/// All subscribers get the same encoding, so depth is predicted only while every path delivers the reference frames.
void Server::choose_prediction() {
  const bool may = listener_->references_arrive();
  if (!origin_->chooses_prediction() || std::exchange(predicts_, may) == may) return;
  origin_->let_predict(may);
  log(may ? "depth images are again predicted from earlier depth images: the network path of each subscriber "
            "loses almost no packet, or repairs each loss in time"
          : "all depth images are now key frames, which take more bytes: the network path of a subscriber is not "
            "measured yet, or loses packets and repairs them too late");
}

void Server::choose_content_often() {
  choose_content();
  content_timer_.expires_after(kContentEvery);
  content_timer_.async_wait([this](const boost::system::error_code& stopped) {
    if (!stopped && !stopped_) choose_content_often();
  });
}

void Server::choose_content() {
  const SessionTime now = clock_.now();
  const std::optional<std::string> said = content_.step({.hub = hub_,
                                                         .peers = listener_->lines(),
                                                         .followed = window_.followed(now),
                                                         .images = origin_->images(),
                                                         .chooses_content = origin_->chooses_content(),
                                                         .now = now});
  if (said) log(*said);
  for (const hub::SubscriberId id : hub_.subscribers()) hub_.give(id, content_.plan().grade_of(id));
  tell_origin_what_is_wanted();
}

/// The C library keeps freed memory for later use. After a backlog, this call returns it to the operating system.
void Server::give_memory_back() {
  constexpr std::size_t kWorthIt = std::size_t{8} << 20;
  most_waiting_bytes_ = std::max(most_waiting_bytes_, hub_.waiting_bytes());
  if (most_waiting_bytes_ - hub_.waiting_bytes() < kWorthIt) return;
  most_waiting_bytes_ = hub_.waiting_bytes();
  malloc_trim(0);
}

void Server::log_state_changes(const wire::Message& message) {
  msg::CaptureStatus status;
  if (!status.ParseFromString(*message.payload)) return;
  const std::string state = origin_->in_words(status);
  if (std::exchange(last_state_, state) != state) log(state);
}

void Server::log(const std::string& text) const {
  if (options_.log) options_.log(text);
}

std::string Server::summary() const {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  hub::Hub::TopicCount depth;
  for (const auto& [topic, count] : hub_.topic_counts()) {
    if (!is_depth(topic)) continue;
    depth.published += count.published;
    depth.sent += count.sent;
    depth.dropped += count.dropped;
  }
  char line[200];
  std::snprintf(line, sizeof line,
                "%.1f s; frames captured: %llu; depth images: %llu published, %llu sent to subscribers, %llu dropped",
                seconds, static_cast<unsigned long long>(origin_ ? origin_->images() : 0),
                static_cast<unsigned long long>(depth.published), static_cast<unsigned long long>(depth.sent),
                static_cast<unsigned long long>(depth.dropped));
  return line;
}

}  // namespace telepalp::server
