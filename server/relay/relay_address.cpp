#include "server/relay/relay_address.h"

#include <algorithm>

namespace telepalp::relay {
namespace {

constexpr std::size_t kLongestSite = 64;

bool is_site(std::string_view name) noexcept {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= kLongestSite && std::ranges::all_of(name, fits);
}

/// With this, the subjects of a site begin.
std::string root_of(const std::string& site) { return "telepalp." + site + "."; }

/// The topics' names hold no dot, so that the subject of a topic names it alone.
std::string with_dots(std::string_view topic) {
  std::string subject(topic.substr(1));
  std::ranges::replace(subject, '/', '.');
  return subject;
}

}  // namespace

Result<RelayAddress> parse_relay(std::string_view text, std::string_view where) {
  const std::string_view path = text.substr(0, text.find('?'));
  const std::size_t scheme = path.find("://");
  const std::size_t slash = path.rfind('/');
  if (!nats::is_address(path) || slash <= scheme + 3 || !is_site(path.substr(slash + 1)))
    return Error{.what =
                     "the address of a relay has the form nats://HOST[:PORT]/SITE, where SITE is letters, digits, "
                     "'-' and '_'",
                 .where = std::string(where),
                 .fix = "give, for example, nats://cluster.example/ward3, or tls:// if the cluster asks for TLS"};
  Result<nats::Address> cluster =
      nats::parse_address(std::string(path.substr(0, slash)) + std::string(text.substr(path.size())), where);
  if (!cluster) return cluster.error();
  return RelayAddress{.cluster = *std::move(cluster), .site = std::string(path.substr(slash + 1))};
}

std::string in_words(const RelayAddress& address) {
  return nats::without_password(address.cluster.url) + "/" + address.site;
}

std::string subject_of(const std::string& site, const wire::Topic& topic) {
  return root_of(site) + with_dots(topic.name);
}

std::string all_subjects(const std::string& site) { return root_of(site) + ">"; }

std::optional<wire::Topic> topic_of(const std::string& site, std::string_view subject) {
  const std::string begin = root_of(site);
  if (!subject.starts_with(begin)) return std::nullopt;
  const auto found = std::ranges::find_if(wire::kTopics, [&](const wire::Topic& topic) {
    return is_relayed(topic) && with_dots(topic.name) == subject.substr(begin.size());
  });
  if (found == wire::kTopics.end()) return std::nullopt;
  return *found;
}

std::string clock_subject(const std::string& site) { return root_of(site) + "ask.clock"; }
std::string again_subject(const std::string& site) { return root_of(site) + "ask.again"; }

bool is_relayed(const wire::Topic& topic) noexcept {
  return topic.name != wire::kClock.name && topic.name != wire::kServerStats.name &&
         topic.name != wire::kViewerHand.name && topic.name != wire::kCameraDepthWindow.name &&
         !topic.spoken;
}

}  // namespace telepalp::relay
