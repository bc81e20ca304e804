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

bool is_relay(std::string_view source) noexcept {
  return source.starts_with("nats://") || source.starts_with("tls://");
}

Result<RelayAddress> parse_relay(std::string_view text, std::string_view where) {
  const std::size_t question = text.find('?');
  std::string_view files = question == text.npos ? "" : text.substr(question + 1);
  text = text.substr(0, question);
  const std::size_t scheme = text.find("://");
  const std::size_t slash = text.rfind('/');
  if (!is_relay(text) || slash <= scheme + 3 || !is_site(text.substr(slash + 1)))
    return Error{.what =
                     "the address of a relay has the form nats://HOST[:PORT]/SITE, where SITE is letters, digits, "
                     "'-' and '_'",
                 .where = std::string(where),
                 .fix = "give, for example, nats://cluster.example/ward3, or tls:// if the cluster asks for TLS"};
  RelayAddress address{.url = std::string(text.substr(0, slash)), .site = std::string(text.substr(slash + 1))};
  while (!files.empty()) {
    const std::string_view one = files.substr(0, files.find('&'));
    files.remove_prefix(std::min(files.size(), one.size() + 1));
    if (one.starts_with("creds=") && one.size() > 6)
      address.credentials = one.substr(6);
    else if (one.starts_with("ca=") && one.size() > 3)
      address.authority = one.substr(3);
    else
      return Error{.what = "'" + std::string(one.substr(0, 64)) + "' is neither creds=FILE nor ca=FILE",
                   .where = std::string(where),
                   .fix = "give, for example, tls://cluster.example/ward3?creds=site.creds&ca=cluster.crt"};
  }
  return address;
}

std::string in_words(const RelayAddress& address) { return without_password(address.url) + "/" + address.site; }

std::string without_password(const std::string& url) {
  const std::size_t host = url.find("://") + 3;
  const std::size_t at = url.rfind('@');
  return url.substr(0, host) + url.substr(at == std::string::npos ? host : at + 1);
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
         topic.name != wire::kViewerHand.name && topic.name != wire::kCameraDepthWindow.name;
}

}  // namespace telepalp::relay
