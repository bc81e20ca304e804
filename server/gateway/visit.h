#pragma once

#include <optional>
#include <string>

#include "server/gateway/gateway.h"
#include "server/gateway/http_reply.h"

namespace telepalp::gateway {

/// One who is signed in, at the web port.
struct Visitor {
  keys::Identity who;
  std::string cookie;  ///< of the browser's session; empty: a token came with the request, or there are no keys
};

/// One request of the web port: who sends it, and the replies to what needs permission. Signing in and out happens
/// here.
class Visit {
 public:
  /// `address`: of the peer, without its port.
  Visit(GatewayContext& context, const HttpRequest& request, std::string address);

  [[nodiscard]] const std::optional<Visitor>& visitor() const noexcept { return visitor_; }
  [[nodiscard]] bool brought_token() const noexcept { return brought_token_; }
  [[nodiscard]] bool may(keys::Operation operation) const;

  /// The reply to a request that is not for everyone; nullopt: the visitor may have what it asks for.
  [[nodiscard]] std::optional<HttpReply> reply(const HttpRequest& request);

 private:
  [[nodiscard]] HttpReply sign_in(const HttpRequest& request);
  [[nodiscard]] HttpReply sign_out(const HttpRequest& request);
  [[nodiscard]] HttpReply metrics(const HttpRequest& request) const;
  void note(access::AuditEvent event, const std::string& text) const;

  GatewayContext& context_;
  std::string address_;
  std::optional<Visitor> visitor_;
  bool brought_token_ = false;
  std::string problem_;  // with the token that came
};

}  // namespace telepalp::gateway
