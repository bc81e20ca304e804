#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/topics.h"
#include "proto/words/result.h"
#include "support/nats/nats_address.h"

namespace telepalp::relay {

/// Where a site's messages are in a cluster of NATS servers.
struct RelayAddress {
  nats::Address cluster;
  std::string site;  ///< letters, digits, '-' and '_'
};

/// Reads `nats://HOST[:PORT]/SITE[?creds=FILE][&ca=FILE]`. `where`: the option's name, for errors.
[[nodiscard]] Result<RelayAddress> parse_relay(std::string_view text, std::string_view where);

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
