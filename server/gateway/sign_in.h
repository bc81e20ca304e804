#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "server/gateway/http_reply.h"

namespace telepalp::gateway {

/// Name of the sign-in's cookie. Because of the prefix `__Host-`, browsers send the cookie over HTTPS to this host
/// alone.
inline constexpr std::string_view kCookieName = "__Host-telepalp";
inline constexpr std::string_view kSignInTarget = "/sign-in";
inline constexpr std::string_view kSignOutTarget = "/sign-out";
inline constexpr std::string_view kSignAtOwnPage =
    "this page is not from this server, or was opened by a name that the server's key does not have. fix: open this "
    "server's page by its IP address or a host that its key names";
inline constexpr const char* kAskPatientFirst =
    "nobody is watched without knowing it. Ask the patient, then check the box";

/// What the page for signing in shows.
struct SignInForm {
  std::string problem{};      ///< why the browser is not signed in; empty: it has not tried
  std::string page = "/";     ///< page_asked() of what the browser requested first
  bool has_hospital = false;  ///< the page offers the hospital's account, too
};

/// The page for signing in.
[[nodiscard]] HttpReply sign_in_page(const HttpRequest& request, const SignInForm& form);
/// A page that says `text` and goes on to `address` by itself. Browsers take this for a link on this server's own page;
/// they take a redirect for a step of the page before. After a redirect from the provider they would not send the
/// cookie kCookieName (SameSite=Strict), and the sign-in page's form may not be redirected to another host
/// (form-action).
[[nodiscard]] HttpReply going_on_page(const HttpRequest& request, const std::string& text, const std::string& address);
/// The page with a button that signs out.
[[nodiscard]] HttpReply sign_out_page(const HttpRequest& request, const std::string& who);
/// A redirect to `target`.
[[nodiscard]] HttpReply go_to(const HttpRequest& request, std::string_view target);
/// The Set-Cookie header for the cookie kCookieName, which the browser keeps for `valid`.
[[nodiscard]] std::string kept_cookie(const std::string& cookie, std::chrono::system_clock::duration valid);
/// A redirect to `target` that sets the cookie kCookieName to `cookie`, which the browser keeps for `valid`.
[[nodiscard]] HttpReply go_to(const HttpRequest& request, std::string_view target, const std::string& cookie,
                              std::chrono::system_clock::duration valid);

/// `target` without its query.
[[nodiscard]] std::string_view path_of(std::string_view target) noexcept;
/// The viewer's page, "/", with the query of `target`, such as ?view=doctor, which the browser requested before signing
/// in. The query is left out if it has more than 200 characters, or characters other than letters, digits and
/// =&._-
[[nodiscard]] std::string page_asked(std::string_view target);

/// The value of the field `token` in a posted form.
[[nodiscard]] std::string token_in_form(std::string_view body);
/// True if a posted form states that the patient has agreed to be watched.
[[nodiscard]] bool states_consent(std::string_view body) noexcept;
/// True if the request comes from a page of this server: a page of another origin must not sign anybody in or out.
[[nodiscard]] bool is_from_our_page(const HttpRequest& request, const RequestPolicy& policy);
/// The value of the cookie `name` in a Cookie header; empty: the header does not have it.
[[nodiscard]] std::string_view cookie_named(std::string_view cookies, std::string_view name) noexcept;
/// The value of the cookie kCookieName in a Cookie header; empty: the header does not have it.
[[nodiscard]] std::string_view our_cookie(std::string_view cookies) noexcept;
/// The token of an Authorization header `Bearer TOKEN`; empty: the header has no token.
[[nodiscard]] std::string_view bearer_token(std::string_view authorization) noexcept;
/// The token of a request's target `/?token=TOKEN`; empty: the target has no token.
[[nodiscard]] std::string_view token_in_target(std::string_view target) noexcept;

}  // namespace telepalp::gateway
