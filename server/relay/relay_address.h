#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/topics.h"
#include "proto/words/result.h"

namespace telepalp::relay {

/// Where a site's messages are in a cluster of NATS servers.
struct RelayAddress {
  std::string url;   ///< as NATS takes it: nats://[USER:PASSWORD@]HOST[:PORT], or tls://…; several, with commas
  std::string site;  ///< letters, digits, '-' and '_'
  std::string credentials{};  ///< NATS's credentials file (.creds); empty: none
  std::string authority{};    ///< file with the certificate of a tls:// server's authority; empty: the system's
};

/// True if `source` begins as an address of a relay does: nats:// or tls://.
[[nodiscard]] bool is_relay(std::string_view source) noexcept;

/// Reads `nats://HOST[:PORT]/SITE[?creds=FILE][&ca=FILE]`. `where`: the option's name, for errors.
[[nodiscard]] Result<RelayAddress> parse_relay(std::string_view text, std::string_view where);

/// `url` without names and passwords, for logs. Of several servers it keeps only those after the last password, because
/// a password may contain a comma.
[[nodiscard]] std::string without_password(const std::string& url);
/// `address` without the password, for logs.
[[nodiscard]] std::string in_words(const RelayAddress& address);

/// The subject of a topic's messages: "telepalp.SITE.camera.depth" for "/camera/depth".
[[nodiscard]] std::string subject_of(const std::string& site, const wire::Topic& topic);
/// The subject under which all topics and requests of `site` are, for a subscription.
[[nodiscard]] std::string all_subjects(const std::string& site);
/// The topic whose messages come under this subject of `site`; nullopt: none.
[[nodiscard]] std::optional<wire::Topic> topic_of(const std::string& site, std::string_view subject);

/// Requests of an edge to the server of `site`: the time, or the latched messages and a key frame.
[[nodiscard]] std::string clock_subject(const std::string& site);
[[nodiscard]] std::string again_subject(const std::string& site);

/// True for the topics that a relay carries: those that describe patient and station. An edge has a clock, counts and
/// viewers' hands of its own.
[[nodiscard]] bool is_relayed(const wire::Topic& topic) noexcept;

}  // namespace telepalp::relay
