#include "server/gateway/sign_in/hospital_visit.h"

#include <utility>

#include "proto/keys/audit_text.h"
#include "server/gateway/request/reading_request.h"
#include "server/gateway/sign_in.h"
#include "server/oidc/hospital_sign_in.h"

namespace telepalp::gateway {
namespace {

namespace http = boost::beast::http;
using oidc::HospitalSignIn;

constexpr std::string_view kLeaveTarget = "/sign-in/hospital";
/// Comes back from the provider's pages, so SameSite=Strict would not do.
constexpr std::string_view kLogInCookie = "__Host-telepalp-log-in";

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

std::string log_in_cookie(const std::string& value, std::chrono::seconds kept) {
  return std::string(kLogInCookie) + "=" + value +
         "; Path=/; Secure; HttpOnly; SameSite=Lax; Max-Age=" + std::to_string(kept.count());
}

/// What the person at the browser reads. An error with a place is for the technician, who finds it in the server's log.
std::string for_person(const Error& why) {
  if (why.where.empty()) return why.what + ". " + why.fix;
  return "the hospital's log-in does not work now: " + why.what + ". Tell the technician, or sign in with a token";
}

/// One browser on its way. Copied into the provider's answer.
struct HospitalVisit {
  GatewayContext& context;
  HttpRequest head;  // the request without its body
  std::string address;
  std::function<void(HttpReply)> reply;

  void note(access::AuditEvent event, const std::optional<keys::Identity>& who, const std::string& text) const {
    context.options.access->note(event, who, text + " program=browser from=" + address);
  }

  void refuse_with(const Error& why, const std::string& page) const {
    note(access::AuditEvent::Refused, std::nullopt, "why=" + keys::audit_text(why.what));
    reply(sign_in_page(head, {.problem = for_person(why), .page = page, .has_hospital = true}));
  }

  void left(const Result<HospitalSignIn::Departure>& departure, const std::string& page) const {
    if (!departure) return refuse_with(departure.error(), page);
    HttpReply there = going_on_page(head, "You are led to your hospital's log-in.", departure->address);
    there.set(http::field::set_cookie, log_in_cookie(departure->cookie, oidc::StartedLogIns::kLongest));
    reply(std::move(there));
  }

  void arrived(const Result<HospitalSignIn::Arrival>& arrival) const {
    if (!arrival) return refuse_with(arrival.error(), "/");
    const keys::Identity& who = arrival->person.who;
    if (const std::optional<Error> over = context.options.access->why_over(who))
      return refuse_with(*over, arrival->page);
    note(access::AuditEvent::SignedIn, who,
         "consent=stated name=" + keys::audit_text(arrival->person.full_name) +
             " issuer=" + keys::audit_text(context.options.hospital->settings().issuer) +
             " sub=" + keys::audit_text(arrival->person.subject));
    HttpReply in = going_on_page(head, "You are signed in as " + describe(who) + ".", arrival->page);
    const std::string cookie = context.sessions.begin(who, std::chrono::steady_clock::now());
    in.set(http::field::set_cookie, kept_cookie(cookie, who.expires - std::chrono::system_clock::now()));
    in.insert(http::field::set_cookie, log_in_cookie("", std::chrono::seconds(0)));
    reply(std::move(in));
  }
};

void leave(const HospitalVisit& visit, const HttpRequest& request, const boost::asio::ip::address& peer) {
  const GatewayOptions& options = visit.context.options;
  const std::string page = page_asked(view(request.target()));
  if (!is_from_our_page(request, options.policy))
    return visit.reply(refuse(request, http::status::forbidden, kSignAtOwnPage));
  if (!states_consent(request.body()))
    return visit.reply(sign_in_page(request, {.problem = kAskPatientFirst, .page = page, .has_hospital = true}));
  const std::string& own = options.hospital->settings().page;  // the cookie must be there when the browser comes back
  if (own != "https://" + std::string(view(request[http::field::host])))
    return visit.reply(
        going_on_page(request, "The hospital's log-in leads to " + own + ": sign in there.", own + page));
  options.hospital->leave(
      page, peer, [visit, page](const Result<HospitalSignIn::Departure>& departure) { visit.left(departure, page); });
}

void arrive(const HospitalVisit& visit, const HttpRequest& request, const boost::asio::ip::address& peer) {
  const std::string_view target = view(request.target());
  const HospitalSignIn::Return brought{.cookie = cookie_named(view(request[http::field::cookie]), kLogInCookie),
                                       .state = query_value(target, "state"),
                                       .code = query_value(target, "code"),
                                       .error = query_value(target, "error")};
  visit.context.options.hospital->arrive(
      brought, peer, [visit](const Result<HospitalSignIn::Arrival>& arrival) { visit.arrived(arrival); });
}

}  // namespace

bool answer_hospital(GatewayContext& context, const HttpRequest& request, const boost::asio::ip::address& peer,
                     const std::function<void(HttpReply)>& reply) {
  const std::string_view path = path_of(view(request.target()));
  const bool leaves = path == kLeaveTarget && request.method() == http::verb::post;
  const bool arrives = path == oidc::kBackTarget && request.method() == http::verb::get;
  if (!leaves && !arrives) return false;
  const HospitalVisit visit{
      .context = context, .head = HttpRequest(request.base()), .address = peer.to_string(), .reply = reply};
  leaves ? leave(visit, request, peer) : arrive(visit, request, peer);
  return true;
}

}  // namespace telepalp::gateway
