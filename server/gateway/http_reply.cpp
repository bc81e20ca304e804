#include "server/gateway/http_reply.h"

#include <string>

#include "server/gateway/request/request_headers.h"

namespace telepalp::gateway {
namespace {

namespace http = boost::beast::http;

/// Allows content from this server only, and no code from strings. `blob:` images are the camera's pictures;
/// 'wasm-unsafe-eval' allows the decoder, a WebAssembly module from this server.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; "
    "img-src 'self' blob: data:; font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

HttpReply with_security(HttpReply reply, const HttpRequest& request) {
  reply.version(11);
  reply.keep_alive(request.keep_alive());
  reply.set("Content-Security-Policy", kContentSecurityPolicy);
  reply.set("X-Content-Type-Options", "nosniff");
  reply.set("X-Frame-Options", "DENY");
  reply.set("Referrer-Policy", "no-referrer");
  reply.set("Cross-Origin-Opener-Policy", "same-origin");
  reply.set("Cross-Origin-Resource-Policy", "same-origin");
  reply.set("Permissions-Policy", "camera=(), microphone=(self), geolocation=()");
  if (request.method() == http::verb::head) {
    reply.content_length(reply.body().size());
    reply.body().clear();
  } else {
    reply.prepare_payload();
  }
  return reply;
}

/// One form of a file: the name of its coding, its tag and its bytes.
struct Form {
  std::string_view coding;
  const std::string& etag;
  const std::string& bytes;
};

/// The smallest form that the client takes. Browsers list "br" over HTTPS and on loopback alone.
Form form_for(const StaticFile& file, std::string_view accept_encoding) {
  if (!file.brotli_bytes.empty() && takes_coding(accept_encoding, "br"))
    return {"br", file.brotli_etag, file.brotli_bytes};
  if (!file.gzip_bytes.empty() && takes_coding(accept_encoding, "gzip"))
    return {"gzip", file.gzip_etag, file.gzip_bytes};
  return {"", file.etag, file.bytes};
}

/// File names are the same in each build, so a browser must ask each time; the ETag avoids the transfer of an unchanged
/// file.
HttpReply serve(const HttpRequest& request, const StaticFile& file) {
  const auto [coding, etag, bytes] = form_for(file, view(request[http::field::accept_encoding]));
  const bool has_it = names_etag(view(request[http::field::if_none_match]), etag);
  HttpReply reply{has_it ? http::status::not_modified : http::status::ok, 11};
  reply.set(http::field::content_type, file.content_type);
  reply.set(http::field::cache_control, "no-cache");
  reply.set(http::field::etag, etag);
  if (!file.gzip_bytes.empty() || !file.brotli_bytes.empty()) reply.set(http::field::vary, "Accept-Encoding");
  if (!coding.empty())
    reply.set(http::field::content_encoding, boost::beast::string_view(coding.data(), coding.size()));
  if (!has_it) reply.body() = bytes;
  return with_security(std::move(reply), request);
}

HttpReply clock(const HttpRequest& request, SessionTime now) {
  HttpReply reply{http::status::ok, 11};
  reply.set(http::field::content_type, "text/plain; charset=utf-8");
  reply.set(http::field::cache_control, "no-store");
  reply.body() = std::to_string(to_nanoseconds(now));
  return with_security(std::move(reply), request);
}

}  // namespace

HttpReply refuse(const HttpRequest& request, http::status status, std::string_view reason) {
  HttpReply reply{status, 11};
  reply.set(http::field::content_type, "text/plain; charset=utf-8");
  reply.set(http::field::cache_control, "no-store");
  if (status == http::status::method_not_allowed) reply.set(http::field::allow, "GET, HEAD");
  reply.body() = std::string(reason) + "\n";
  return with_security(std::move(reply), request);
}

HttpReply reply_to(const HttpRequest& request, const StaticFiles& files, const RequestPolicy& policy, SessionTime now) {
  if (!host_is_ours(policy, view(request[http::field::host])))
    return refuse(request, http::status::misdirected_request, kNotOurHost);
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(request, http::status::method_not_allowed, "this address answers only GET and HEAD");
  if (view(request.target()) == kClockTarget) return clock(request, now);
  const StaticFile* const file = files.find(view(request.target()));
  if (file == nullptr) return refuse(request, http::status::not_found, "this server has no file at this address");

  return serve(request, *file);
}

}  // namespace telepalp::gateway
