#include "server/content_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proto/wire/camera/color_message.h"
#include "server/access/access.h"

namespace telepalp::server {
namespace {

constexpr double kSmooth = 0.3;  ///< weight of the newest step in a smoothed rate: a mean over about half a second

/// `peer`: ADDRESS:PORT. An IPv6 address is in square brackets.
bool is_loopback(const std::string& peer) {
  const std::string address = access::host_of(peer);
  return address.starts_with("127.") || address == "[::1]" || address.starts_with("[::ffff:127.");
}

std::uint64_t image_bytes(const hub::Hub::SubscriberCount& count) {
  std::uint64_t bytes = 0;
  for (const wire::Topic& topic :
       {wire::kCameraDepth, wire::kCameraDepthWindow, wire::kCameraColor, wire::kCameraColorVideo})
    if (const auto found = count.topics.find(topic.name); found != count.topics.end()) bytes += found->second.bytes;
  return bytes;
}

/// The line of a subscriber that has no peer: of a browser, which shows images, or of a part of the server.
plan::Line line_of(const hub::Hub& hub, hub::SubscriberId id, const hub::Hub::SubscriberCount& count, bool is_local) {
  return {.subscriber = id,
          .kind = count.shows_images && !is_local ? plan::Line::Kind::Viewer : plan::Line::Kind::Keeper,
          .takes_window = hub.takes(id, wire::kCameraDepthWindow.name),
          .takes_whole = hub.takes(id, wire::kCameraDepth.name),
          .takes_pictures = hub.takes(id, wire::kCameraColor.name),
          .takes_video = hub.takes(id, wire::kCameraColorVideo.name),
          .report = {.offered = count.images, .dropped = count.crowded_out, .sent_B = image_bytes(count)}};
}

plan::Line::Kind kind_of(hub::PlaceKind place, bool is_local) {
  if (place == hub::PlaceKind::Station) return plan::Line::Kind::Station;
  return place == hub::PlaceKind::Viewer && !is_local ? plan::Line::Kind::Viewer : plan::Line::Kind::Keeper;
}

/// The lines of all subscribers. The hand is the station whose window is followed. Until a station asks for a window,
/// it is the first station that takes depth with a window.
std::vector<plan::Line> lines_of(const ContentChoice::Site& site) {
  std::vector<plan::Line> lines;
  bool has_hand = false;
  for (const hub::SubscriberId id : site.hub.subscribers()) {
    const hub::Hub::SubscriberCount& count = site.hub.count_of(id);
    // Datagrams from this machine may come through telepalp-link, which imitates a thin line.
    const bool is_local = is_loopback(count.address) && !count.by_datagram;
    plan::Line line = line_of(site.hub, id, count, is_local);
    const auto peer = std::ranges::find(site.peers, id, &hub::PeerListener::PeerLine::subscriber);
    if (peer != site.peers.end()) {
      line.report.share_B_per_s = peer->share_B_per_s;
      line.report.queue = peer->queue;
      line.kind = kind_of(peer->kind, is_local);
      const bool is_followed = line.takes_window && site.followed.value_or(peer->sender) == peer->sender;
      if (line.kind == plan::Line::Kind::Station && is_followed && !std::exchange(has_hand, true))
        line.kind = plan::Line::Kind::Hand;
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

void ContentChoice::published(const wire::Message& message, plan::Grade grade) {
  plan::Made& made = made_[plan::index_of(grade)];
  plan::Made::Count* const count = message.topic.name == wire::kCameraDepthWindow.name ? &made.window
                                   : message.topic.name == wire::kCameraDepth.name     ? &made.whole
                                   : message.topic.name == wire::kCameraColor.name     ? &made.pictures
                                                                                       : nullptr;
  const std::size_t bytes = message.payload->size();
  if (count != nullptr) {
    ++count->images;
    count->bytes += bytes;
  }
  if (grade == plan().grade_of_stations() && (count != nullptr || wire::carries_color(message.topic)))
    bytes_ += static_cast<double>(bytes);
}

std::optional<std::string> ContentChoice::step(const Site& site) {
  const double span_s = std::max(1e-3, to_seconds(site.now - std::exchange(stepped_at_, site.now)));
  std::optional<std::string> said = choose_level(site, span_s);
  plan_rates(site, span_s);
  return said;
}

/// All stations that take whole depth images get the same ones, so these become smaller for the thinnest line.
std::optional<std::string> ContentChoice::choose_level(const Site& site, double span_s) {
  image_rate_B_per_s_ += kSmooth * (std::exchange(bytes_, 0.0) / span_s - image_rate_B_per_s_);
  std::optional<double> share;
  double dropped = 0.0;
  for (const hub::PeerListener::PeerLine& peer : site.peers) {
    if (peer.kind != hub::PlaceKind::Station || site.hub.takes(peer.subscriber, wire::kCameraDepthWindow.name))
      continue;
    const double left = peer.share_B_per_s.value_or(0.0);
    if (peer.share_B_per_s) share = share ? std::min(*share, left) : left;
    dropped = std::max(dropped, peer.dropped);
  }
  const std::size_t before = level_.level();
  level_.step({.share_B_per_s = share, .demand_B_per_s = image_rate_B_per_s_, .dropped = dropped}, site.now);
  if (level_.level() == before) return std::nullopt;
  if (before == 0 && !share)
    return "the line of a station has no room for all images: they are made smaller, so that more arrive";
  if (before == 0)
    return "something else uses the line of a station, and leaves " +
           std::to_string(std::lround(share.value_or(0.0) * 8e-3)) +
           " kbit/s: images are made smaller, so that as many arrive";
  if (level_.level() > 0) return std::nullopt;
  return "images are again as large as before: the line of each station has room for them";
}

void ContentChoice::plan_rates(const Site& site, double span_s) {
  const std::uint64_t before = std::exchange(images_, site.images);
  const double rate = site.images >= before ? static_cast<double>(site.images - before) / span_s : 0.0;
  images_per_s_ += kSmooth * (rate - images_per_s_);
  plan::PlanInput input{.made = std::exchange(made_, {}), .images_per_s = images_per_s_, .whole_level = level_.level()};
  if (site.chooses_content) input.lines = lines_of(site);
  notice_.step(planner_.step(input, site.now).sacrifice, site.now);
}

}  // namespace telepalp::server
