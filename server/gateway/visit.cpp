#include "server/gateway/visit.h"

#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "proto/keys/audit_text.h"
#include "server/gateway/health/metrics.h"
#include "server/gateway/request/reading_request.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/sign_in.h"
#include "support/program/message_json.h"

namespace telepalp::gateway {
namespace {

namespace http = boost::beast::http;

auto steady_now() { return std::chrono::steady_clock::now(); }

/// A browser's page cannot add a header to a WebSocket, and our cookie stays with our pages. So a page of an allowed
/// origin names the token in the stream's address. Other addresses carry no token: they stay in histories and
/// bookmarks.
std::string_view token_of(const HttpRequest& request) {
  const std::string_view token = bearer_token(view(request[http::field::authorization]));
  const bool is_stream = boost::beast::websocket::is_upgrade(request);
  return token.empty() && is_stream ? token_in_target(view(request.target())) : token;
}

constexpr std::string_view kSignInFirst =
    "sign in first: open this server's page, or send the header Authorization: Bearer TOKEN";

/// Reply to a command of a program that is signed in by a cookie alone.
constexpr std::string_view kNoTokenNoOrigin =
    "this request has neither the header Origin of a web page nor the token of a program. fix: send the header "
    "Authorization: Bearer TOKEN";

HttpReply json_reply(const HttpRequest& request, const std::string& json) {
  HttpReply reply = refuse(request, http::status::ok, json);
  reply.set(http::field::content_type, "application/json");
  return reply;
}

/// Session time at which the state after a command was published on the topic of the command's path [ns]; 0: nobody has
/// subscribed to it. A page that shows the topic waits for this state.
constexpr const char* kStatePublished = "State-Published";

/// GET answers the state. POST carries out a command, and answers the state after it, which `states` publishes.
void answer_state(const HttpRequest& request, std::string_view path, const origin::Resource& resource,
                  origin::StatePublisher& states, const std::string& who, const Visit::Reply& reply) {
  if (request.method() == http::verb::get) return reply(json_reply(request, program::to_json(*resource.state())));
  if (!resource.change)
    return reply(refuse(request, http::status::method_not_allowed, "this address answers only GET"));
  if (request.method() != http::verb::post)
    return reply(refuse(request, http::status::method_not_allowed,
                        "this address answers only GET (the state) and POST (a command)"));
  HttpRequest head(request.base());  // the command may take longer than the request lives
  resource.change(request.body(), who,
                  [head = std::move(head), path, resource, &states, reply](const Result<void>& changed) {
                    if (!changed) return reply(refuse(head, http::status::bad_request, to_string(changed.error())));
                    states.commanded();
                    HttpReply after = json_reply(head, program::to_json(*resource.state()));
                    after.set(kStatePublished, std::to_string(to_nanoseconds(states.published_at(path))));
                    reply(std::move(after));
                  });
}

constexpr std::string_view kReadingIsOver =
    "this session was opened for one page, which is closed. fix: load the page again";

}  // namespace

Visit::Visit(GatewayContext& context, const HttpRequest& request, const boost::asio::ip::address& peer)
    : context_(context), peer_(peer), address_(peer.to_string()), is_on_this_machine_(peer.is_loopback()) {
  access::Access& access = *context_.options.access;
  const std::string_view token = token_of(request);
  const std::string cookie(our_cookie(view(request[http::field::cookie])));
  if (!access.has_keys()) {
    const Result<keys::Identity> local = access.who({});
    visitor_ = Visitor{.who = *local, .cookie = {}};
  } else if (!token.empty()) {
    const Result<keys::Identity> bearer = access.bearer(token, address_);
    brought_token_ = bearer.ok();
    if (bearer) visitor_ = Visitor{.who = *bearer, .cookie = {}};
    if (!bearer) {
      note(access::AuditEvent::Refused, std::nullopt, "why=" + keys::audit_text(bearer.error().what));
      problem_ = bearer.error().what + ". " + bearer.error().fix;
    }
  } else if (const auto who = context_.sessions.find(cookie, steady_now()); who && access.still_holds(*who)) {
    visitor_ = Visitor{.who = *who, .cookie = cookie};
  }
}

bool Visit::may(keys::Operation operation) const {
  return visitor_ && context_.options.access->may(visitor_->who, operation).ok();
}

bool Visit::answer(const HttpRequest& request, const Reply& reply) {
  if (const ResourceRow* const row = resource_at(path_of(view(request.target())))) {
    resource(request, *row, reply);
    return true;
  }
  if (answer_hospital(request, reply)) return true;
  std::optional<HttpReply> answer = page(request);
  if (answer) reply(std::move(*answer));
  return answer.has_value();
}

/// nullopt: the visitor may get the requested page.
std::optional<HttpReply> Visit::page(const HttpRequest& request) {
  const std::string_view target = path_of(view(request.target()));
  const bool has_keys = context_.options.access->has_keys();
  if (target == kMetricsTarget) return metrics(request);
  if (!has_keys) return std::nullopt;
  if (target == kSignInTarget && request.method() == http::verb::post) return sign_in(request);
  if (!may(keys::Operation::Watch)) {
    if (target == "/" || target == kSignInTarget) return sign_in_form(request, problem_);
    return refuse(request, http::status::unauthorized, kSignInFirst);
  }
  if (target == kSignInTarget) return go_to(request, page_asked(view(request.target())));
  if (target != kSignOutTarget) return std::nullopt;
  return request.method() == http::verb::post ? sign_out(request) : sign_out_page(request, describe(visitor_->who));
}

HttpReply Visit::sign_in_form(const HttpRequest& request, const std::string& problem) const {
  return sign_in_page(request, {.problem = problem,
                                .page = page_asked(view(request.target())),
                                .has_hospital = context_.options.hospital != nullptr});
}

HttpReply Visit::sign_in(const HttpRequest& request) {
  if (!is_from_our_page(request, context_.options.policy))
    return refuse(request, http::status::forbidden, kSignAtOwnPage);
  if (!states_consent(request.body())) return sign_in_form(request, kAskPatientFirst);
  access::Access& access = *context_.options.access;
  const Result<keys::Identity> who =
      access.sign_in(token_in_form(request.body()), address_, our_cookie(view(request[http::field::cookie])));
  if (!who) {
    note(access::AuditEvent::Refused, std::nullopt, "why=" + keys::audit_text(who.error().what));
    return sign_in_form(request, who.error().what + ". " + who.error().fix);
  }
  note(access::AuditEvent::SignedIn, *who, "consent=stated");
  const std::string cookie = context_.sessions.begin(*who, steady_now());
  access.bind_to_browser(*who, cookie);
  return go_to(request, page_asked(view(request.target())), cookie, who->expires - std::chrono::system_clock::now());
}

HttpReply Visit::sign_out(const HttpRequest& request) {
  if (!is_from_our_page(request, context_.options.policy))
    return refuse(request, http::status::forbidden, kSignAtOwnPage);
  if (const auto who = context_.sessions.end(visitor_->cookie)) note(access::AuditEvent::SignedOut, who, {});
  return go_to(request, "/");  // the cookie stays: without it, this browser could not use its token again
}

HttpReply Visit::metrics(const HttpRequest& request) const {
  if (!may(keys::Operation::Metrics))
    return refuse(request, visitor_ ? http::status::forbidden : http::status::unauthorized,
                  "metrics need a token of a technician or of QA: send the header Authorization: Bearer TOKEN");
  if (!host_is_ours(context_.options.policy, view(request[http::field::host])))
    return refuse(request, http::status::misdirected_request, kNotOurHost);
  const std::string text =
      metrics_text(context_.hub, context_.options.access->counts(),
                   context_.options.datagrams ? context_.options.datagrams() : hub::DatagramCounts{},
                   {.browsers = context_.connections.size(),
                    .touch_is_held = context_.options.access->touch().holder(steady_now()).has_value(),
                    .is_healthy = !context_.options.problem || context_.options.problem().empty()}) +
      (context_.options.more_metrics ? context_.options.more_metrics() : "");
  HttpReply reply = refuse(request, http::status::ok, text);
  reply.set(http::field::content_type, "text/plain; version=0.0.4; charset=utf-8");
  return reply;
}

std::optional<HttpReply> Visit::refusal_to_watch(const HttpRequest& request) const {
  if (!host_is_ours(context_.options.policy, view(request[http::field::host])))
    return refuse(request, http::status::misdirected_request, kNotOurHost);
  if (!may(keys::Operation::Watch)) return refuse(request, http::status::unauthorized, kSignInFirst);
  return std::nullopt;
}

/// A POST must come from a page of this server, a page of an origin in --allow-origin, or a trusted program. `is_own`:
/// the state is of a reading, which nobody but its reader sees.
std::optional<HttpReply> Visit::refusal(const HttpRequest& request, const ResourceRow& row, bool is_own) const {
  if (std::optional<HttpReply> refusal = refusal_to_watch(request)) return refusal;
  if (!may(row.read)) return refuse(request, http::status::forbidden, row.people);
  if (request.method() != http::verb::post) return std::nullopt;
  if (!may(is_own ? row.change_own : row.change)) return refuse(request, http::status::forbidden, row.people);
  const std::string_view origin = view(request[http::field::origin]);
  if (!origin_is_allowed(context_.options.policy, origin, view(request[http::field::host]), is_from_trusted_program()))
    return refuse(request, http::status::forbidden, origin.empty() ? kNoTokenNoOrigin : row.pages);
  return std::nullopt;
}

void Visit::resource(const HttpRequest& request, const ResourceRow& row, const Reply& reply) const {
  const std::string id(query_value(view(request.target()), "reading"));
  const std::shared_ptr<origin::Reading> reading = context_.readings.find(id);
  if (std::optional<HttpReply> refused = refusal(request, row, reading != nullptr)) return reply(std::move(*refused));
  if (!id.empty() && !reading) return reply(refuse(request, http::status::not_found, kReadingIsOver));
  const origin::Resources& all = reading ? reading->offer().resources : context_.options.offer.resources;
  const auto found = all.find(row.path);
  const bool commands = request.method() == http::verb::post;
  if (found == all.end())
    return reply(row.empty_if_absent && !commands ? json_reply(request, "{}")
                                                  : refuse(request, http::status::not_found, row.absent));
  const std::string who = describe(visitor_->who);
  if (commands && row.audited_as) note(*row.audited_as, visitor_->who, "asked=" + keys::audit_text(request.body()));
  origin::StatePublisher& states = reading ? reading->states() : *context_.states;
  // The reply keeps the reading, and so the resource and its states, until the command has been carried out.
  answer_state(request, row.path, found->second, states, who,
               [reading, reply](HttpReply answer) { reply(std::move(answer)); });
}

/// Who may watch sees each moment of the session that the server plays. A recording of the server's folder may be of
/// another patient: it needs the right to record.
std::shared_ptr<origin::Reading> Visit::reading(const HttpRequest& request) const {
  const Result<std::optional<ReadingRequest>> asked = read_reading_request(view(request.target()));
  if (!asked) return context_.readings.failed({}, asked.error());
  if (!*asked) return nullptr;
  const origin::ReadingSpec& spec = (*asked)->spec;
  const keys::Operation needed = spec.session.empty() ? keys::Operation::Watch : keys::Operation::Record;
  if (const Result<void> allowed = context_.options.access->may(visitor_->who, needed); !allowed)
    return context_.readings.failed(spec, allowed.error());
  std::shared_ptr<origin::Reading> joined = context_.readings.join((*asked)->id, spec);
  if (!spec.session.empty() && joined->state().phase() != msg::ReadingState::PHASE_FAILED)
    note(access::AuditEvent::OpenedSession, visitor_->who, "session=" + keys::audit_text(spec.session));
  return joined;
}

void Visit::note(access::AuditEvent event, const std::optional<keys::Identity>& who, const std::string& text) const {
  context_.options.access->note(event, who, text + (text.empty() ? "" : " ") + "program=browser from=" + address_);
}

}  // namespace telepalp::gateway
