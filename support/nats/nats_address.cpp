#include "support/nats/nats_address.h"

#include <algorithm>

namespace telepalp::nats {

bool is_address(std::string_view text) noexcept { return text.starts_with("nats://") || text.starts_with("tls://"); }

Result<Address> parse_address(std::string_view text, std::string_view where) {
  const std::size_t question = text.find('?');
  std::string_view files = question == text.npos ? "" : text.substr(question + 1);
  const std::string_view url = text.substr(0, question);
  // A path, such as the site of a relay, would be ignored by libnats.
  if (!is_address(url) || url.ends_with("/") || url.rfind('/') != url.rfind("://") + 2)
    return Error{.what = "the address of a cluster has the form nats://HOST[:PORT]",
                 .where = std::string(where),
                 .fix = "give, for example, nats://cluster.example, or tls:// if the cluster asks for TLS"};
  Address address{.url = std::string(url)};
  while (!files.empty()) {
    const std::string_view one = files.substr(0, files.find('&'));
    files.remove_prefix(std::min(files.size(), one.size() + 1));
    if (one.starts_with("creds=") && one.size() > 6)
      address.credentials = one.substr(6);
    else if (one.starts_with("ca=") && one.size() > 3)
      address.authority = one.substr(3);
    else
      // It is not repeated here, because a password with a '?' would be shown.
      return Error{.what = "a part of the address after its '?' is neither creds=FILE nor ca=FILE",
                   .where = std::string(where),
                   .fix = "end the address with, for example, ?creds=site.creds&ca=cluster.crt"};
  }
  return address;
}

std::string without_password(const std::string& address) {
  const std::size_t host = address.find("://") + 3;
  const std::size_t at = address.substr(0, address.find('?')).rfind('@');
  return address.substr(0, host) + address.substr(at == std::string::npos ? host : at + 1);
}

}  // namespace telepalp::nats
