// The browser's way to the hospital's provider and back: the part of Visit that needs it.
#include <utility>

#include "proto/keys/audit_text.h"
#include "server/gateway/http_reply.h"
#include "server/gateway/request/reading_request.h"
#include "server/gateway/sign_in.h"
#include "server/gateway/visit.h"

namespace telepalp::gateway {
namespace {

namespace http = boost::beast::http;
using oidc::HospitalSignIn;

constexpr std::string_view kLeaveTarget = "/sign-in/hospital";
/// Not SameSite=Strict: browsers do not send such a cookie when a page of the provider leads them here.
constexpr std::string_view kLogInCookie = "__Host-telepalp-log-in";

std::string log_in_cookie(const std::string& value, std::chrono::seconds kept) {
  return std::string(kLogInCookie) + "=" + value +
         "; Path=/; Secure; HttpOnly; SameSite=Lax; Max-Age=" + std::to_string(kept.count());
}

/// What the person at the browser reads. An error with a place is for the technician, who finds it in the server's log.
std::string for_person(const Error& why) {
  if (why.where.empty()) return why.what + ". " + why.fix;
  return "the hospital's log-in does not work now: " + why.what + ". Tell the technician, or sign in with a token";
}

}  // namespace

bool Visit::answer_hospital(const HttpRequest& request, const Reply& reply) {
  if (context_.options.hospital == nullptr) return false;
  const std::string_view path = path_of(view(request.target()));
  if (path == kLeaveTarget && request.method() == http::verb::post) {
    leave_for_hospital(request, reply);
    return true;
  }
  if (path != oidc::kBackTarget || request.method() != http::verb::get) return false;
  arrive_from_hospital(request, reply);
  return true;
}

HttpReply Visit::hospital_refused(const HttpRequest& request, const Error& why, const std::string& page) const {
  note(access::AuditEvent::Refused, std::nullopt, "why=" + keys::audit_text(why.what));
  return sign_in_page(request, {.problem = for_person(why), .page = page, .has_hospital = true});
}

void Visit::leave_for_hospital(const HttpRequest& request, const Reply& reply) {
  const std::string page = page_asked(view(request.target()));
  if (!is_from_our_page(request, context_.options.policy))
    return reply(refuse(request, http::status::forbidden, kSignAtOwnPage));
  if (!states_consent(request.body()))
    return reply(sign_in_page(request, {.problem = kAskPatientFirst, .page = page, .has_hospital = true}));
  HospitalSignIn& hospital = *context_.options.hospital;
  const std::string& own =
      hospital.settings().page;  // under another name of this server, the browser would not send the cookie back
  if (own != "https://" + std::string(view(request[http::field::host])))
    return reply(going_on_page(request, "The hospital's log-in leads to " + own + ": sign in there.", own + page));
  // `reply` owns the connection, which owns this visit.
  hospital.leave(
      page, peer_,
      [this, page, reply, head = HttpRequest(request.base())](const Result<HospitalSignIn::Departure>& departure) {
        if (!departure) return reply(hospital_refused(head, departure.error(), page));
        HttpReply there = going_on_page(head, "You are led to your hospital's log-in.", departure->address);
        there.set(http::field::set_cookie, log_in_cookie(departure->cookie, oidc::StartedLogIns::kLongest));
        reply(std::move(there));
      });
}

void Visit::arrive_from_hospital(const HttpRequest& request, const Reply& reply) {
  const std::string_view target = view(request.target());
  const HospitalSignIn::Return brought{.cookie = cookie_named(view(request[http::field::cookie]), kLogInCookie),
                                       .state = query_value(target, "state"),
                                       .code = query_value(target, "code"),
                                       .error = query_value(target, "error")};
  context_.options.hospital->arrive(
      brought, peer_,
      [this, reply, head = HttpRequest(request.base())](const Result<HospitalSignIn::Arrival>& arrival) {
        if (!arrival) return reply(hospital_refused(head, arrival.error(), "/"));
        const std::optional<Error> over = context_.options.access->why_over(arrival->person.who);
        reply(over ? hospital_refused(head, *over, arrival->page) : let_in(head, arrival->person, arrival->page));
      });
}

HttpReply Visit::let_in(const HttpRequest& request, const oidc::Person& person, const std::string& page) const {
  const keys::Identity& who = person.who;
  note(access::AuditEvent::SignedIn, who,
       "consent=stated name=" + keys::audit_text(person.full_name) + " issuer=" +
           keys::audit_text(context_.options.hospital->settings().issuer) + " sub=" + keys::audit_text(person.subject));
  HttpReply in = going_on_page(request, "You are signed in as " + describe(who) + ".", page);
  const std::string cookie = context_.sessions.begin(who, std::chrono::steady_clock::now());
  in.set(http::field::set_cookie, kept_cookie(cookie, who.expires - std::chrono::system_clock::now()));
  in.insert(http::field::set_cookie, log_in_cookie("", std::chrono::seconds(0)));
  return in;
}

}  // namespace telepalp::gateway
