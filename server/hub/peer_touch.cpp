#include "server/hub/peer_touch.h"

#include <utility>

#include "proto/keys/audit_text.h"

namespace telepalp::hub {
namespace {

using namespace std::chrono_literals;

constexpr auto kShortestBetweenOffers = 500ms;  // so that offers do not fill the audit log

msg::HandOver answer(const std::string& to, bool done, std::string outcome) {
  msg::HandOver answer;
  answer.set_to(to);
  answer.set_done(done);
  answer.set_outcome(std::move(outcome));
  return answer;
}

}  // namespace

PeerTouch::Taken PeerTouch::take(const keys::Identity& who, bool accepts) {
  if (!access_.has_keys()) return {.may_touch = true, .from = std::nullopt};
  access::TouchLease& lease = access_.touch();
  const std::optional<std::string> before = lease.holder(Clock::now());
  const access::TouchLease::Station station{
      .peer = peer_, .run = run_, .serial = who.serial, .name = who.name, .accepts = accepts};
  std::optional<std::uint64_t> from = lease.older_connection(station);
  std::string how = from ? "by=new-connection" : "";
  holds_ = lease.take(station, Clock::now());
  if (!holds_ && accepts) {
    from = lease.accept(station, Clock::now());
    holds_ = from.has_value();
    if (holds_) how = "by=hand-over from=" + keys::audit_text(*before);
  }
  access_.keep_touch();
  if (holds_) audit_(access::AuditEvent::TookTouch, how);
  return {.may_touch = holds_, .from = from};
}

bool PeerTouch::renew() {
  if (!holds_) return true;
  holds_ = access_.touch().renew(peer_, Clock::now());
  if (holds_) return true;
  const bool taken_away = access_.touch().must_accept(run_, Clock::now());
  audit_(access::AuditEvent::GaveTouch,
         "why=" + keys::audit_text(taken_away ? "the technician took it away" : "silent for 10 s"));
  return false;
}

std::string PeerTouch::lose_to(const keys::Identity& who, bool is_same_doctor) {
  if (std::exchange(holds_, false)) audit_(access::AuditEvent::GaveTouch, "to=" + keys::audit_text(describe(who)));
  if (is_same_doctor) return "the touch goes to a newer connection of " + describe(who);
  return "the touch is handed over to " + describe(who) + ", who has accepted it";
}

void PeerTouch::leave(bool on_purpose) {
  if (std::exchange(holds_, false)) audit_(access::AuditEvent::GaveTouch, {});
  access_.touch().leave(peer_, on_purpose, Clock::now());
  access_.keep_touch();
}

msg::HandOver PeerTouch::offer(const keys::Identity& who, const std::string& to) {
  const auto refuse = [&](const std::string& why) { return answer(to, false, why); };
  if (!access_.has_keys())
    return refuse(
        "this server has no keys, so nobody holds the touch. fix: stop this station, then start the other station");
  if (const Result<void> may = access_.may(who, keys::Operation::HandOver); !may) {
    audit_(access::AuditEvent::Refused, "why=" + keys::audit_text(may.error().what));
    return refuse(to_string(may.error()));
  }
  if (to == who.name)
    return refuse("the touch cannot be offered to your own name. fix: name the other doctor, as in that doctor's key");
  const Clock::time_point now = Clock::now();
  if (offered_at_ && now - *offered_at_ < kShortestBetweenOffers)
    return refuse("the last offer was made just now. fix: wait 1 s, then offer again");
  if (!access_.touch().offer(peer_, to, now))
    return refuse("this station does not hold the touch. fix: " +
                  std::string(holds_ ? "start this station again" : "wait until this station holds the touch"));
  offered_at_ = now;
  return answer(to, true, offered(to));
}

std::string PeerTouch::offered(const std::string& to) {
  audit_(access::AuditEvent::OfferedTouch, to.empty() ? "to=nobody" : "to=" + keys::audit_text(to));
  if (to.empty()) return "the offer is withdrawn: you keep the touch";
  return "the touch is offered to doctor " + to + " for " + std::to_string(access::TouchLease::kOffer.count()) +
         " s: you keep the touch until that doctor accepts it";
}

std::string PeerTouch::is_held(const keys::Identity& who) const {
  const access::TouchLease& lease = access_.touch();
  const std::optional<std::string> holder = lease.holder(Clock::now());
  if (lease.must_accept(run_, Clock::now()))
    return "the touch is free, and this station waits for its doctor. fix: to begin, run telepalp-station hand-over "
           "--accept at this station";
  if (!holder)  // this station's lease had ended, another doctor took the touch, and has given it back since
    return "this station lost the touch, because it was silent for 10 s. fix: wait: the station connects again by "
           "itself, and takes the touch unless another doctor holds it then";
  if (lease.offered_to(Clock::now()) == who.name)
    return "doctor " + *holder +
           " offers you the touch. fix: to accept the touch, run telepalp-station hand-over --accept";
  return "doctor " + *holder +
         " holds the touch. fix: wait until that doctor's station ends or is silent for 10 s, or ask that doctor to "
         "offer you the touch: telepalp-station hand-over --to " +
         who.name;
}

}  // namespace telepalp::hub
