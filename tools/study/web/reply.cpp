#include "tools/study/web/reply.h"

namespace telepalp::study {
namespace {

namespace http = boost::beast::http;

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

constexpr std::string_view kNotOurHost = "open the page by the address that telepalp-study printed";
constexpr std::string_view kNoToken =
    "the address lacks the token of this program. fix: open the address that telepalp-study printed last";

/// Allows content from this program alone, and no code from strings.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

HttpReply with_security(HttpReply reply, const HttpRequest& request) {
  reply.version(11);
  reply.keep_alive(request.keep_alive());
  reply.set(http::field::cache_control, "no-store");
  reply.set("Content-Security-Policy", kContentSecurityPolicy);
  reply.set("X-Content-Type-Options", "nosniff");
  reply.set("Referrer-Policy", "no-referrer");
  reply.set("Cross-Origin-Opener-Policy", "same-origin");
  reply.set("Cross-Origin-Resource-Policy", "same-origin");
  if (request.method() == http::verb::head) {
    reply.content_length(reply.body().size());
    reply.body().clear();
  } else {
    reply.prepare_payload();
  }
  return reply;
}

HttpReply refuse(const HttpRequest& request, http::status status, std::string_view reason) {
  HttpReply reply{status, 11};
  reply.set(http::field::content_type, "text/plain; charset=utf-8");
  if (status == http::status::method_not_allowed) reply.set(http::field::allow, "GET, HEAD");
  reply.body() = std::string(reason) + "\n";
  return with_security(std::move(reply), request);
}

}  // namespace

HttpReply reply_to(const HttpRequest& request, const PageFiles& files, const Door& door) {
  if (!host_is_ours(door, view(request[http::field::host])))
    return refuse(request, http::status::misdirected_request, kNotOurHost);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(request, http::status::method_not_allowed, "this address answers only GET and HEAD");
  const std::string_view target = view(request.target());
  const auto file = files.find(target.substr(0, target.find('?')));
  if (file == files.end()) return refuse(request, http::status::not_found, "this program has no file at this address");
  HttpReply reply{http::status::ok, 11};
  reply.set(http::field::content_type, boost::beast::string_view(file->second.type.data(), file->second.type.size()));
  reply.body() = file->second.bytes;
  return with_security(std::move(reply), request);
}

std::optional<HttpReply> refusal_of_live(const HttpRequest& request, const Door& door) {
  const std::string_view host = view(request[http::field::host]);
  const std::string_view target = view(request.target());
  if (!host_is_ours(door, host)) return refuse(request, http::status::misdirected_request, kNotOurHost);
  if (!origin_is_ours(door, view(request[http::field::origin]), host))
    return refuse(request, http::status::forbidden, "a page of another site may not use this program");
  if (target.substr(0, target.find('?')) != kLiveTarget)
    return refuse(request, http::status::not_found, "the WebSocket of this program is at /live");
  if (!has_token(door, target)) return refuse(request, http::status::unauthorized, kNoToken);
  return std::nullopt;
}

}  // namespace telepalp::study
