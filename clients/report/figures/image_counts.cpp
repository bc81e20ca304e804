#include "clients/report/figures/image_counts.h"

#include <algorithm>

#include "clients/report/figures/html.h"
#include "proto/words/time.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

std::uint64_t less(std::uint64_t all, std::uint64_t part) { return all > part ? all - part : 0; }

std::string carrier_name(const Carrier& carrier) { return carrier.by_datagram ? "UDP (encrypted datagrams)" : "TCP"; }

}  // namespace

std::string carriers_in_words(const Session& session, const Summary& summary) {
  if (summary.carriers.empty()) return "";
  std::string text = carrier_name(summary.carriers.front());
  bool changed = false, by_datagram = summary.carriers.front().by_datagram;
  for (const Carrier& carrier : summary.carriers) {
    if (carrier.by_datagram == by_datagram) continue;
    by_datagram = carrier.by_datagram;
    changed = true;
    const double at_s = to_seconds(Nanoseconds(carrier.since_ns - session.first_ns.value_or(0)));
    text += " until " + plot::number(at_s, 1) + " s, then " + carrier_name(carrier);
  }
  return text + (changed ? "" : " for the whole session");
}

std::string shared_line_in_words(const SharedLine& line) {
  if (line.seconds == 0) return "";
  return " For " + std::to_string(line.seconds) +
         " s something else used the station's line, such as a download; at least " +
         plot::number(8e-6 * line.least_B_per_s, 1) + " Mbit/s were left for the images.";
}

std::string image_counts_section(const Session& session, const Summary& summary) {
  if (!summary.frames_sent || !summary.frames_dropped || !summary.frames_received) return "";
  const std::uint64_t sent = *summary.frames_sent, received = *summary.frames_received;
  const std::uint64_t all = sent + *summary.frames_dropped, unused = summary.frames_unused.value_or(0);
  const std::uint64_t lost = less(sent, received + summary.frames_on_the_way);
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const char* what, std::uint64_t images) {
    const double share = all > 0 ? 100.0 * static_cast<double>(images) / static_cast<double>(all) : kUnknown;
    rows.push_back({what, std::to_string(images), plot::number(share, 1) + " %"});
  };
  add("the server had for the station", all);
  add("dropped by the server before it sent them: a newer image came first", *summary.frames_dropped);
  add("lost between server and station: packets were lost, or a newer image was complete first", lost);
  add("still on the way when the station last counted (estimated)", summary.frames_on_the_way);
  add("received by the station", received);
  add("received and not used: a newer image came first, or it could not be decoded", unused);
  const std::string carrier = carriers_in_words(session, summary);
  return section("Depth images from the server to the station",
                 "Every share is of the images that the server had for the station during the recording. Server and "
                 "station count once a second, so that the rows can differ by a second's images from their sum." +
                     (carrier.empty() ? "" : " The images went by " + carrier + ".") +
                     shared_line_in_words(summary.shared_line),
                 table({"depth images that …", "number", "share"}, rows));
}

}  // namespace telepalp::report
