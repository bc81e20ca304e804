#pragma once

#include <boost/asio/ip/address.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"
#include "server/gateway/request/resource_table.h"

namespace telepalp::gateway {

/// A person who is signed in at the gateway.
struct Visitor {
  keys::Identity who;
  std::string cookie;  ///< of the browser's session; empty: the request has a token, or the server has no keys
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

  /// The session that `request`, a WebSocket upgrade, asks to see for its reader alone; null: it asks for none. The
  /// reading has failed if the visitor has not the right to it.
  [[nodiscard]] std::shared_ptr<origin::Reading> reading(const HttpRequest& request) const;

  using Reply = std::function<void(HttpReply)>;
  /// True: `reply` is called once, now or later, with the reply to a request that needs permission (sign-in, sign-out,
  /// metrics, a resource), or with a refusal. False: the visitor may get the requested page.
  [[nodiscard]] bool answer(const HttpRequest& request, const Reply& reply);

 private:
  [[nodiscard]] HttpReply sign_in_form(const HttpRequest& request, const std::string& problem) const;
  [[nodiscard]] HttpReply sign_in(const HttpRequest& request);
  /// True: the request begins or ends a log-in at the hospital's provider, and `reply` is called once, now or later.
  [[nodiscard]] bool answer_hospital(const HttpRequest& request, const Reply& reply);
  void leave_for_hospital(const HttpRequest& request, const Reply& reply);
  void arrive_from_hospital(const HttpRequest& request, const Reply& reply);
  [[nodiscard]] HttpReply hospital_refused(const HttpRequest& request, const Error& why, const std::string& page) const;
  [[nodiscard]] HttpReply let_in(const HttpRequest& request, const oidc::Person& person, const std::string& page) const;
  [[nodiscard]] HttpReply sign_out(const HttpRequest& request);
  [[nodiscard]] HttpReply metrics(const HttpRequest& request) const;
  [[nodiscard]] std::optional<HttpReply> page(const HttpRequest& request);
  void resource(const HttpRequest& request, const ResourceRow& row, const Reply& reply) const;
  [[nodiscard]] std::optional<HttpReply> refusal_to_watch(const HttpRequest& request) const;
  [[nodiscard]] std::optional<HttpReply> refusal(const HttpRequest& request, const ResourceRow& row, bool is_own) const;
  void note(access::AuditEvent event, const std::optional<keys::Identity>& who, const std::string& text) const;

  GatewayContext& context_;
  boost::asio::ip::address peer_;
  std::string address_;  // of the peer, without its port
  bool is_on_this_machine_;
  std::optional<Visitor> visitor_;
  bool brought_token_ = false;
  std::string problem_;  // why the request's token was refused, for the sign-in page; empty: not refused
};

}  // namespace telepalp::gateway
