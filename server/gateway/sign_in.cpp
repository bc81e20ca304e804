#include "server/gateway/sign_in.h"

#include <openssl/evp.h>

#include <array>

#include "proto/keys/audit_chain.h"
#include "server/gateway/request/reading_request.h"
#include "server/gateway/request_policy.h"

namespace telepalp::gateway {
namespace {

namespace http = boost::beast::http;

/// The look of the viewer's cards.
constexpr std::string_view kStyle =
    "body{margin:0;min-height:100vh;display:grid;place-items:center;background:#05070b;color:#e8eef4;"
    "font:16px/1.5 system-ui,sans-serif}"
    "main{box-sizing:border-box;width:min(26rem,100vw);padding:2rem;background:#0c1219;border:1px solid #22303d;"
    "border-radius:12px}"
    "h1{margin:0 0 1rem;font-size:1.3rem}p{margin:1rem 0 0;color:#a9bac8;font-size:.9rem}"
    "label{display:block;margin:0 0 1rem}input[type=password]{box-sizing:border-box;width:100%;margin-top:.25rem;"
    "padding:.6rem;font:inherit;color:inherit;background:#05070b;border:1px solid #3a4d5e;border-radius:8px}"
    "button{width:100%;padding:.6rem;font:inherit;font-weight:600;color:#04121a;background:#5fd0e8;border:0;"
    "border-radius:8px;cursor:pointer}:focus-visible{outline:2px solid #ffd166;outline-offset:2px}"
    "summary{margin:1.5rem 0 0;color:#a9bac8;cursor:pointer}[open] summary{margin-bottom:1rem}a{color:#5fd0e8}"
    "[role=alert]{margin:0 0 1rem;padding:.6rem .8rem;color:#ffd9a0;background:#3a2a0b;border-radius:8px}";

std::string sha256_in_base64(std::string_view text) {
  const std::array digest = keys::sha256(text);
  std::array<unsigned char, 4 * ((digest.size() + 2) / 3) + 1> base64{};
  const int length = EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(digest.size()));
  return {reinterpret_cast<const char*>(base64.data()), static_cast<std::size_t>(length)};
}

/// A page of our own, without script: it may post a form to this server, and has this one style.
const std::string& form_policy() {
  static const std::string policy = "default-src 'none'; style-src 'sha256-" + sha256_in_base64(kStyle) +
                                    "'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'";
  return policy;
}

std::string html_escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) switch (letter) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  return safe;
}

HttpReply page(const HttpRequest& request, http::status status, const std::string& body) {
  HttpReply reply = refuse(request, status,
                           "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
                           "content=\"width=device-width\"><title>telepalp</title><style>" +
                               std::string(kStyle) + "</style><body><main>" + body + "</main></body></html>");
  reply.set(http::field::content_type, "text/html; charset=utf-8");
  reply.set("Content-Security-Policy", form_policy());
  reply.set("Referrer-Policy", "same-origin");  // with "no-referrer" a browser sends a form's origin as "null"
  return reply;
}

constexpr std::string_view kConsentBox =
    "<label><input name=\"consent\" type=\"checkbox\" value=\"yes\" required> The patient has agreed that I "
    "watch</label>";

/// `query`: the query of the page that the browser requested, escaped for HTML.
std::string hospital_form(const std::string& query) {
  return "<form method=\"post\" action=\"/sign-in/hospital" + query + "\">" + std::string(kConsentBox) +
         "<button autofocus>Sign in with your hospital's account</button></form>";
}

std::string token_form(const std::string& query) {
  return "<form method=\"post\" action=\"/sign-in" + query +
         "\"><label>Token <input name=\"token\" type=\"password\" autocomplete=\"off\" autofocus required></label> " +
         std::string(kConsentBox) +
         "<button>Sign in</button></form>"
         "<p>The token is all that follows <code>token:</code> in the file that the technician gave you.</p>";
}

}  // namespace

HttpReply sign_in_page(const HttpRequest& request, const SignInForm& form) {
  const std::string why = form.problem.empty() ? "" : "<p role=\"alert\">" + html_escaped(form.problem) + "</p>";
  const std::string query = html_escaped(form.page.substr(1));
  const std::string forms =
      form.has_hospital
          ? hospital_form(query) + "<details><summary>Sign in with a token</summary>" + token_form(query) + "</details>"
          : token_form(query);
  return page(request, http::status::unauthorized, "<h1>telepalp</h1>" + why + forms);
}

HttpReply going_on_page(const HttpRequest& request, const std::string& text, const std::string& address) {
  const std::string safe = html_escaped(address);
  return page(request, http::status::ok,
              "<meta http-equiv=\"refresh\" content=\"0; url=" + safe + "\"><h1>telepalp</h1><p>" + html_escaped(text) +
                  "</p><p><a href=\"" + safe + "\">Go on</a></p>");
}

HttpReply sign_out_page(const HttpRequest& request, const std::string& who) {
  return page(request, http::status::ok,
              "<h1>telepalp</h1><p>You are signed in as " + html_escaped(who) +
                  ".</p><form method=\"post\" action=\"/sign-out\"><button>Sign out</button></form>");
}

HttpReply go_to(const HttpRequest& request, std::string_view target) {
  HttpReply reply = refuse(request, http::status::see_other, "");
  reply.set(http::field::location, boost::beast::string_view(target.data(), target.size()));
  return reply;
}

HttpReply go_to(const HttpRequest& request, std::string_view target, const std::string& cookie,
                std::chrono::system_clock::duration valid) {
  HttpReply reply = go_to(request, target);
  reply.set(http::field::set_cookie, kept_cookie(cookie, valid));
  return reply;
}

std::string kept_cookie(const std::string& cookie, std::chrono::system_clock::duration valid) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(valid).count();
  return std::string(kCookieName) + "=" + cookie +
         "; Path=/; Secure; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds);
}

std::string_view path_of(std::string_view target) noexcept { return target.substr(0, target.find('?')); }

std::string page_asked(std::string_view target) {
  constexpr std::size_t kLongest = 200;
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789=&._-";
  const std::string_view query = target.substr(path_of(target).size());
  if (query.size() > kLongest || query.find_first_not_of(kPlain, 1) != std::string_view::npos) return "/";
  return "/" + std::string(query);
}

std::string token_in_form(std::string_view body) {
  constexpr std::string_view kField = "token=";
  if (!body.starts_with(kField)) return {};
  std::string_view value = body.substr(kField.size());
  value = value.substr(0, value.find('&'));
  while (value.starts_with('+')) value.remove_prefix(1);  // a space that was pasted with the token
  while (value.ends_with('+')) value.remove_suffix(1);
  return std::string(value);
}

bool states_consent(std::string_view body) noexcept {
  return body == "consent=yes" || body.ends_with("&consent=yes") ||
         body.find("&consent=yes&") != std::string_view::npos;
}

bool is_from_our_page(const HttpRequest& request, const RequestPolicy& policy) {
  const auto host = request[http::field::host];
  const auto origin = request[http::field::origin];
  return host_is_ours(policy, {host.data(), host.size()}) &&
         std::string_view(origin.data(), origin.size()) == "https://" + std::string(host.data(), host.size());
}

std::string_view our_cookie(std::string_view cookies) noexcept { return cookie_named(cookies, kCookieName); }

std::string_view cookie_named(std::string_view cookies, std::string_view name) noexcept {
  while (!cookies.empty()) {
    std::string_view one = cookies.substr(0, cookies.find(';'));
    cookies.remove_prefix(std::min(cookies.size(), one.size() + 1));
    while (one.starts_with(' ')) one.remove_prefix(1);
    if (one.starts_with(name) && one.substr(name.size()).starts_with('=')) return one.substr(name.size() + 1);
  }
  return {};
}

std::string_view bearer_token(std::string_view authorization) noexcept {
  constexpr std::string_view kScheme = "Bearer ";
  return authorization.starts_with(kScheme) ? authorization.substr(kScheme.size()) : std::string_view{};
}

std::string_view token_in_target(std::string_view target) noexcept { return query_value(target, "token"); }

}  // namespace telepalp::gateway
