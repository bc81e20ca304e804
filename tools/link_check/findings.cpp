#include "tools/link_check/findings.h"

#include <cstdio>

namespace telepalp::link_check {
namespace {

using Answer = Port::Answer;
using Udp = Findings::Udp;

constexpr double kTouchableImages_per_s = 15.0;
constexpr double kLateAfter_ms = 300.0;

std::string with(const char* format, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string in_words(const Port& port) {
  switch (port.answer) {
    case Answer::Opens:
      return with("opens after %.1f ms", port.opens_after_ms);
    case Answer::Refuses:
      return "is refused: no program listens there";
    case Answer::Silent:
      return "does not answer: a firewall drops it, or the computer is off";
    case Answer::NotTried:
      break;
  }
  return "was not tried";
}

std::string name_line(const Findings& found) {
  if (found.addresses.empty()) return "is unknown to this computer's name service";
  std::string text = "leads to";
  for (const std::string& address : found.addresses) text += " " + address;
  return text;
}

std::string udp_line(const Findings& found) {
  switch (found.udp) {
    case Udp::Arrives:
      if (!found.way.empty()) return "goes " + found.way;
      return with("arrives at port %u in both directions", unsigned{found.link.number});
    case Udp::Blocked:
      return with("does not arrive at port %u: images and touch go over TCP", unsigned{found.link.number});
    case Udp::NotOffered:
      return "finds no path: images and touch go over TCP through the meeting point";
    case Udp::Unknown:
      break;
  }
  return "was not tried, because no session began";
}

std::string images_line(const Findings& found) {
  if (!found.images) return found.why_no_images;
  return with("%.1f a second, %.1f Mbit/s; on the way %.0f ms (median), %.0f ms (p95); %llu missed",
              found.images->per_s, found.images->Mbit_per_s, found.images->age_p50_ms, found.images->age_p95_ms,
              static_cast<unsigned long long>(found.images->missed));
}

std::string session_obstacle(const Findings& found) {
  if (found.addresses.empty())
    return "no session, because the name is unknown. fix: check the name, or give an address: --connect 10.0.0.5";
  if (found.link.answer != Answer::Opens)
    return with("no session, because TCP port %u %s. fix: %s", unsigned{found.link.number},
                in_words(found.link).c_str(),
                found.link.answer == Answer::Refuses
                    ? "start telepalp-server there, with --bind 0.0.0.0 and --key"
                    : "open this port at the server's site, or use a meeting point: --connect SITE@HOST");
  return "no session: " + to_string(*found.no_session);
}

std::string verdict(const Findings& found) {
  if (found.no_session) return session_obstacle(found);
  if (found.images && found.images->per_s < kTouchableImages_per_s)
    return with(
        "watching works, touch does not: it needs %.0f images a second. fix: use a line with a higher rate, "
        "or end what else uses this one",
        kTouchableImages_per_s);
  if (found.round_trip_ms > kLateAfter_ms)
    return with("touch works, but what is felt is %.0f ms old. fix: none, unless there is a shorter way to the site",
                found.round_trip_ms);
  if (found.relayed)
    return "touch works, but takes a way around over the relay. fix: none, unless a firewall can let UDP out";
  if (found.udp == Udp::NotOffered)
    return "touch works, but each lost packet delays it. fix: none, unless the site can open its ports";
  if (found.udp == Udp::Blocked)
    return with("touch works, but each lost packet delays it. fix: open UDP port %u at the server's site",
                unsigned{found.link.number});
  return "this network carries touch";
}

}  // namespace

bool carries_a_session(const Findings& found) {
  return !found.no_session && (!found.images || found.images->per_s > 0.0);
}

std::string in_lines(const Findings& found) {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& says) {
    text += with("%-12s", name.c_str()) + says + "\n";
  };
  line("server", found.server);
  line("name", name_line(found));
  line(with("TCP %u", unsigned{found.link.number}), in_words(found.link));
  if (found.web.number != found.link.number) line(with("web %u", unsigned{found.web.number}), in_words(found.web));
  line("key", found.key.empty() ? "none is given" : found.key);
  line("session", found.no_session ? "does not begin: " + found.no_session->what
                                   : with("begins; round trip %.1f ms", found.round_trip_ms));
  line("UDP", udp_line(found));
  if (!found.notice.empty()) line("but", found.notice);
  line("images", images_line(found));
  line("so", verdict(found));
  return text;
}

}  // namespace telepalp::link_check
