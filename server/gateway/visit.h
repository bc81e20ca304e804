#pragma once

#include <boost/asio/ip/address.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"

namespace telepalp::gateway {

/// Refusals of a command for a played session, over HTTP and over the WebSocket.
inline constexpr std::string_view kNoSession =
    "this server plays no session. fix: start telepalp-server with --source session:FILE.mcap";
inline constexpr std::string_view kOnlyForPlayers = "only technicians and QA may control a played session";

/// Path of session playback: GET returns its state; POST carries out a command, such as a seek or a pause.
inline constexpr std::string_view kPlaybackTarget = "/playback";

/// Path of the events of the whole played session: only GET is allowed.
inline constexpr std::string_view kEventsTarget = "/playback/events";

/// Path of the network that impairs the played session: GET returns its settings and counts; POST changes its
/// settings.
inline constexpr std::string_view kNetworkTarget = "/playback/network";

/// Path of the notes on the played session: GET returns them; POST adds or removes one.
inline constexpr std::string_view kNotesTarget = "/playback/notes";

/// Path of the comparison of the played session with another one: GET returns it; POST chooses the other session.
inline constexpr std::string_view kComparisonTarget = "/playback/comparison";

/// Path of the recording at the server's machine: GET returns its state; POST begins or ends it.
inline constexpr std::string_view kRecordingTarget = "/recording";

/// A person who is signed in at the gateway.
struct Visitor {
  keys::Identity who;
  std::string cookie;  ///< of the browser's session; empty: the request has a token, or the server has no keys
};

/// The permission that a command by POST needs, and the replies to clients that may not send it.
struct CommandRight {
  keys::Operation operation;
  std::string_view people;  ///< "only … may …": reply to a visitor without the right
  std::string_view pages;   ///< reply to a page of a foreign origin
};

/// One HTTP request to the gateway: finds the person who sends it, and makes the replies that need permission, such as
/// signing in and out.
class Visit {
 public:
  Visit(GatewayContext& context, const HttpRequest& request, const boost::asio::ip::address& peer);

  [[nodiscard]] const std::optional<Visitor>& visitor() const noexcept { return visitor_; }
  /// True if the request comes from this machine or brought a valid token. Such a request needs no origin: if it names
  /// none, it comes from a program that may act for its user.
  [[nodiscard]] bool is_from_trusted_program() const noexcept { return is_on_this_machine_ || brought_token_; }
  [[nodiscard]] bool may(keys::Operation operation) const;

  /// The reply to a request that needs permission (sign-in, sign-out, metrics, playback, recording), or a refusal;
  /// nullopt: the visitor may get the requested page.
  [[nodiscard]] std::optional<HttpReply> reply(const HttpRequest& request);

 private:
  [[nodiscard]] HttpReply sign_in(const HttpRequest& request);
  [[nodiscard]] HttpReply sign_out(const HttpRequest& request);
  [[nodiscard]] HttpReply metrics(const HttpRequest& request) const;
  [[nodiscard]] HttpReply played(const HttpRequest& request, const JsonResource& part) const;
  [[nodiscard]] HttpReply session_events(const HttpRequest& request) const;
  [[nodiscard]] HttpReply recording(const HttpRequest& request) const;
  [[nodiscard]] std::optional<HttpReply> refusal_to_watch(const HttpRequest& request) const;
  [[nodiscard]] std::optional<HttpReply> refusal_to_command(const HttpRequest& request,
                                                            const CommandRight& right) const;
  void note(access::AuditEvent event, const std::string& text) const;

  GatewayContext& context_;
  std::string address_;  // of the peer, without its port
  bool is_on_this_machine_;
  std::optional<Visitor> visitor_;
  bool brought_token_ = false;
  std::string problem_;  // why the request's token was refused, for the sign-in page; empty: not refused
};

}  // namespace telepalp::gateway
