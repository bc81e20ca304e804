#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>

#include "proto/words/result.h"
#include "proto/words/time.h"
#include "server/access/access.h"
#include "server/access/unproven.h"
#include "server/gateway/hand_holder.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/sign_in/web_sessions.h"
#include "server/gateway/static_files.h"
#include "server/hub/hub.h"
#include "server/hub/server_stats.h"
#include "server/oidc/hospital_sign_in.h"
#include "server/origin/origin.h"
#include "server/origin/reading.h"
#include "server/origin/state_publisher.h"
#include "server/views/view_maker.h"
#include "server/voice/voice_floor.h"
#include "support/program/while_alive.h"

namespace telepalp::gateway {

struct GatewayOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;             ///< 0: any free port; Gateway::port() returns it
  std::filesystem::path viewer_files{};  ///< empty: no files, only the WebSocket
  std::string server_name = "telepalp";  ///< shown by viewers
  RequestPolicy policy{};
  std::shared_ptr<access::Access> access = access::Access::without_keys();  ///< shared with the listener for stations
  oidc::HospitalSignIn* hospital = nullptr;  ///< lives longer than the gateway; null: people sign in with tokens alone
  std::function<std::string()> problem{};    ///< why the health check fails; empty: healthy
  /// Who speaks at the patient's side; shared with the microphone at the server itself (voice::RoomVoice).
  std::shared_ptr<voice::VoiceFloor> patient_floor = std::make_shared<voice::VoiceFloor>();
  std::function<std::string()> more_metrics{};       ///< Prometheus text that /metrics ends with
  std::function<hub::DatagramCounts()> datagrams{};  ///< counts of datagrams that arrived at the UDP port
  origin::Offer offer{};                             ///< what visitors may see of the server's origin, and change in it
  origin::Resources resources{};                     ///< those of the server itself
  origin::Readings::Open open_session{};  ///< opens a recorded session for one reader; unset: none can be opened
  std::function<void(const std::string&)> log{};  ///< log lines for the technician about refused viewers
  std::size_t max_connections = 64;
  std::chrono::milliseconds request_timeout{10'000};  ///< limit for receiving a request, and for sending the reply
  std::chrono::milliseconds idle_timeout{30'000};     ///< a viewer that does not answer pings is disconnected
};

class Connection;

/// State that all connections of a gateway share. Owner: the server's network thread.
struct GatewayContext {
  hub::Hub& hub;
  GatewayOptions options;
  StaticFiles files;
  std::function<SessionTime()> now;
  std::string session_id;  ///< differs for each start of the server
  origin::Readings readings;
  std::unordered_set<Connection*> connections;  ///< open connections, at most options.max_connections
  HandHolder holder{};
  voice::VoiceFloor doctor_floor{};  ///< who speaks as the doctor
  WebSessions sessions{};
  hub::Hub views{};  ///< topics for viewers alone: views (server/views/view_topics.h) and states of resources
  std::unique_ptr<views::ViewMaker> view_maker{};    ///< null after the gateway's destruction
  std::unique_ptr<origin::StatePublisher> states{};  ///< publishes at `views`
};

/// One accepted socket. Pending reads and writes keep the object alive.
class Connection {
 public:
  explicit Connection(std::shared_ptr<GatewayContext> context);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection();
  /// Closes the connection at once; it does not use the hub afterwards.
  virtual void close() = 0;
  /// Closes the connection if its key or its sign-in has ended; called each second.
  virtual void check_access() {}
  /// Sends the client the state of the played session; called each second.
  virtual void send_playback_state() {}
  /// Tells the client which states the server has now.
  virtual void offer_changed() {}
  /// Publishes the states that this client alone sees; called each StatePublisher::kLook.
  virtual void look_at_own_states() {}
  /// True when the connection is a viewer that has subscribed to nothing and does not control the viewer hand, so that
  /// it may be closed to make room for a new connection.
  [[nodiscard]] virtual bool is_idle() const { return false; }
  /// Address and arrival of a connection that has brought no valid key yet; nullopt: it has.
  [[nodiscard]] virtual std::optional<access::Unproven> unproven() const { return std::nullopt; }

 protected:
  [[nodiscard]] const std::shared_ptr<GatewayContext>& context() const noexcept { return context_; }

 private:
  std::shared_ptr<GatewayContext> context_;  // shared: the last handler may run after the gateway's destruction
};

/// Gives browsers access to the hub: HTTP for the viewer's files and, on the same port at any path, the Foxglove
/// WebSocket protocol. Every viewer is a subscriber of the hub with its own bounded queue, so a slow viewer loses only
/// its own frames. Runs on `io`'s one thread, like the hub.
class Gateway {
 public:
  /// Starts to listen. `now` reads the session clock. Error: the viewer's files cannot be read or the port cannot be
  /// opened.
  [[nodiscard]] static Result<std::unique_ptr<Gateway>> open(boost::asio::io_context& io, hub::Hub& hub,
                                                             std::function<SessionTime()> now, GatewayOptions options);
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;
  /// Stops listening and closes every connection.
  ~Gateway();

  /// Visitors see `offer` instead of GatewayOptions::offer, or of the last call: another origin is shown.
  void offer(origin::Offer offer);

  /// Takes in a visitor whose connection comes through the meeting point, not through this gateway's port.
  void admit(boost::asio::ip::tcp::socket socket);

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  /// The address of the viewer for a browser: "http://127.0.0.1:8080/". If the gateway listens on all addresses, it has
  /// a host of the server's key.
  [[nodiscard]] std::string url() const;
  [[nodiscard]] std::size_t connections() const noexcept { return context_->connections.size(); }

 private:
  Gateway(boost::asio::ip::tcp::acceptor acceptor, std::shared_ptr<GatewayContext> context);
  void accept();
  void make_room(const access::Unproven& newcomer);
  void make_room_among_strangers(const access::Unproven& newcomer);
  void let_go(Connection& connection);
  void look_after_connections_every_second();
  void look_at_states();
  void refuse(boost::asio::ip::tcp::socket socket);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  boost::asio::steady_timer second_;
  boost::asio::steady_timer look_;
  std::shared_ptr<GatewayContext> context_;  // shared with the connections
  std::uint16_t port_ = 0;
  std::chrono::steady_clock::time_point refusal_noted_{};
  program::WhileAlive alive_;
};

}  // namespace telepalp::gateway
