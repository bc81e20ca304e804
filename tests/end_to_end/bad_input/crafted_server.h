#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "messages/station.pb.h"
#include "proto/link/seal/sealed_channel.h"
#include "proto/wire/connection/connection.h"
#include "proto/wire/datagrams/datagram_offer.h"
#include "proto/wire/session_clock.h"

namespace telepalp::bad_input {

/// A server that speaks the protocol over TCP as it should, and seals whatever payload the test wants for its
/// datagrams. Without keys: the offer carries the datagrams' secret. One station at a time, on the io_context's thread.
class CraftedServer : public wire::ConnectionOwner {
 public:
  using tcp = boost::asio::ip::tcp;
  using udp = boost::asio::ip::udp;
  static constexpr std::uint64_t kPacketsPerKey = 16;  ///< so that keys change several times a second

  explicit CraftedServer(boost::asio::io_context& io)
      : acceptor_(io, {boost::asio::ip::make_address("127.0.0.1"), 0}),
        socket_(io, {boost::asio::ip::make_address("127.0.0.1"), acceptor_.local_endpoint().port()}) {
    acceptor_.async_accept([this](const boost::system::error_code& code, tcp::socket socket) {
      if (code) return;
      connection_ = std::make_shared<wire::Connection>(
          wire::plain_tcp(std::move(socket)),
          wire::Connection::Options{
              .name = "crafted", .role = "server", .publishes = {wire::kCameraDepth, wire::kCameraInfo}},
          *this);
      connection_->start();
    });
    read();
  }
  ~CraftedServer() override {
    if (connection_) connection_->abandon();
  }
  CraftedServer(const CraftedServer&) = delete;
  CraftedServer& operator=(const CraftedServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  [[nodiscard]] SessionTime now() const { return clock_.now(); }
  void step_clock(Nanoseconds by) { clock_ = wire::SessionClock{clock_.offset() + by}; }
  /// True once the station's datagrams came, so that it can be sent some.
  [[nodiscard]] bool knows_station() const { return station_.has_value(); }
  [[nodiscard]] std::size_t surfaces() const { return surfaces_; }
  /// From the newest touchable image's capture until it was touchable, by the station's session clock.
  [[nodiscard]] Nanoseconds last_surface_age() const { return last_surface_age_; }
  [[nodiscard]] const std::string& closed() const { return closed_; }

  /// Over TCP.
  void publish(const wire::Topic& topic, const google::protobuf::MessageLite& message) {
    if (!connection_ || !connection_->ready()) return;
    waiting_.push_back({topic, now(), std::make_shared<const std::string>(message.SerializeAsString()),
                        ++sequences_[topic.name], true});
    connection_->wake();
  }
  /// By datagram, sealed with the session's key.
  void seal_and_send(const std::vector<std::byte>& payload) {
    link::Datagram sealed;
    if (!sealer_ || !sealer_->seal(payload, sealed)) return;
    send(sealed.bytes());
  }
  void send(std::span<const std::byte> datagram) {
    boost::system::error_code lost;
    if (station_) socket_.send_to(boost::asio::buffer(datagram.data(), datagram.size()), *station_, 0, lost);
  }
  /// The number of the next message of `topic`, for one that goes by datagram.
  [[nodiscard]] std::uint64_t next_sequence(const wire::Topic& topic) { return ++sequences_[topic.name]; }

 private:
  bool accepts(const wire::Topic&) override { return true; }
  void on_ready(const msg::Hello& hello) override {
    const auto offer = wire::make_offer(0x19202122, hello.datagrams(), std::nullopt);
    if (!offer) return;
    link::SealSettings seal = offer->seal;
    seal.packets_per_epoch = kPacketsPerKey;
    sealer_.emplace(seal, link::Direction::ServerToClient);
    opener_.emplace(offer->seal, link::Direction::ClientToServer);
    connection_->offer_datagrams(offer->message);
  }
  void on_message(wire::Message message) override {
    if (message.topic.name != wire::kStationSurface.name) return;
    ++surfaces_;
    msg::SurfaceReport report;
    if (report.ParseFromString(*message.payload))
      last_surface_age_ = Nanoseconds(static_cast<std::int64_t>(report.touchable_ns() - report.captured_ns()));
  }
  void on_subscribe(std::vector<std::string>) override {}
  void on_clock(const wire::ClockSample&) override {}
  void on_key_frame_request(const wire::Topic&, SessionTime) override {}
  void on_closed(const std::string& reason) override { closed_ = reason; }
  std::optional<wire::Message> next_to_send() override {
    if (waiting_.empty()) return std::nullopt;
    wire::Message next = std::move(waiting_.front());
    waiting_.pop_front();
    return next;
  }
  SessionTime session_now() override { return now(); }

  /// Each report of the station is answered, so that the station holds the path to be good.
  void read() {
    socket_.async_receive_from(
        boost::asio::buffer(buffer_), from_, [this](const boost::system::error_code& code, std::size_t bytes) {
          if (code == boost::asio::error::operation_aborted) return;
          const auto opened = code || !opener_ ? std::nullopt : opener_->open(std::span(buffer_).first(bytes));
          if (opened) answer(*opened, bytes);
          read();
        });
  }
  void answer(const link::Opened& opened, std::size_t bytes) {
    station_ = from_;
    received_bytes_ += bytes;
    seal_and_send(link::write_feedback({.highest_sequence = opened.sequence,
                                        .received_bytes = received_bytes_,
                                        .reported_ns = to_nanoseconds(now()),
                                        .settled = static_cast<std::uint32_t>(opened.sequence)}));
  }

  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  tcp::acceptor acceptor_;
  udp::socket socket_;
  udp::endpoint from_;
  std::optional<udp::endpoint> station_;
  std::array<std::byte, 2048> buffer_{};
  std::uint64_t received_bytes_ = 0;
  std::optional<link::Sealer> sealer_;
  std::optional<link::Opener> opener_;
  std::deque<wire::Message> waiting_;
  std::map<std::string_view, std::uint64_t> sequences_;
  std::size_t surfaces_ = 0;
  Nanoseconds last_surface_age_{0};
  std::string closed_;
  std::shared_ptr<wire::Connection> connection_;
};

}  // namespace telepalp::bad_input
