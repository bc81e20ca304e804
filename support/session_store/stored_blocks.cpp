#include "support/session_store/stored_blocks.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "proto/words/little_endian.h"
#include "support/nats/nats_address.h"

namespace telepalp::session_store {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLongestName = 100;
constexpr std::uint32_t kMostBlock_B = std::uint32_t{512} << 10;
constexpr std::uint32_t kLeastBlock_B = 4096;
constexpr int kCopies = 3;
constexpr auto kPatience = 20s;  // a cluster elects a leader within 4 s
constexpr std::string_view kEnding = ".mcap";
constexpr std::string_view kAboutMagic = "TPSTORE1";
constexpr std::size_t kAboutBytes = 8 + 4 + 1 + 8;

bool is_word(std::string_view text, bool may_have_dots) {
  const auto fits = [&](char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return is_letter || c == '-' || c == '_' || (may_have_dots && c == '.');
  };
  return !text.empty() && text.size() <= kLongestName && text.front() != '.' && std::ranges::all_of(text, fits);
}

/// A subject's word and a stream's name have no dots.
std::string without_dots(std::string text) {
  std::ranges::replace(text, '.', '=');
  return text;
}

std::string of_environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

std::string bytes_of(const StoredBlocks::About& about) {
  std::string bytes(kAboutMagic);
  append_little_endian<std::uint32_t>(bytes, about.block_B);
  bytes += about.size_B ? '\1' : '\0';
  append_little_endian<std::uint64_t>(bytes, about.size_B.value_or(0));
  return bytes;
}

std::optional<StoredBlocks::About> about_in(std::string_view bytes) {
  if (bytes.size() != kAboutBytes || !bytes.starts_with(kAboutMagic)) return std::nullopt;
  StoredBlocks::About about{.block_B = get_little_endian<std::uint32_t>(bytes.data() + 8)};
  if (about.block_B < kLeastBlock_B || about.block_B > kMostBlock_B || (bytes[12] != 0 && bytes[12] != 1))
    return std::nullopt;
  if (bytes[12] == 1) about.size_B = get_little_endian<std::uint64_t>(bytes.data() + 13);
  if (about.size_B.value_or(0) > StoredBlocks::kMostBlocks * about.block_B) return std::nullopt;
  return about;
}

}  // namespace

Result<SessionName> parse_name(const std::string& name) {
  const Error wrong{.what = "is not the name of a session in a cluster",
                    .where = nats::without_password(name),
                    .fix =
                        "give nats://HOST[:PORT]/SITE/SESSION.mcap, with letters, digits, '-' and '_'; credentials by "
                        "TELEPALP_NATS_CREDS=FILE"};
  const std::size_t last = name.rfind('/');
  const std::size_t before = last == 0 || last == name.npos ? name.npos : name.rfind('/', last - 1);
  if (before == name.npos || !name.ends_with(kEnding) || name.find('@') != name.npos) return wrong;
  const Result<nats::Address> cluster = nats::parse_address(name.substr(0, before), "session");
  if (!cluster) return wrong;
  SessionName read{.cluster = *cluster,
                   .site = name.substr(before + 1, last - before - 1),
                   .session = name.substr(last + 1, name.size() - last - 1 - kEnding.size())};
  if (!is_word(read.site, false) || !is_word(read.session, true)) return wrong;
  read.cluster.credentials = of_environment("TELEPALP_NATS_CREDS");
  read.cluster.authority = of_environment("TELEPALP_NATS_CA");
  return read;
}

StoredBlocks::StoredBlocks(const SessionName& name)
    : stream_("TELEPALP+SESSION+" + name.site + "+" + without_dots(name.session)),
      subjects_("telepalp-session." + name.site + "." + without_dots(name.session) + ".") {}

Result<std::unique_ptr<StoredBlocks>> StoredBlocks::connect(const SessionName& name) {
  std::unique_ptr<StoredBlocks> blocks(new StoredBlocks(name));
  auto connection = nats::NatsConnection::open({.address = name.cluster, .name = "session " + name.session});
  if (!connection) return connection.error();
  blocks->connection_ = *std::move(connection);
  auto streams = nats::Streams::open(*blocks->connection_);
  if (!streams) return streams.error();
  blocks->streams_ = *std::move(streams);
  return blocks;
}

Result<void> StoredBlocks::create(std::chrono::hours kept_for) {
  const Result<bool> exists = streams_->has(stream_);
  if (!exists) return exists.error();
  if (*exists)
    return Error{
        .what = "exists already in the cluster", .where = stream_, .fix = "choose another name for the session"};
  return streams_->keep({.name = stream_,
                         .subjects = {subjects_ + ">"},
                         .is_work_queue = false,
                         .longest_kept = kept_for,
                         .copies = kCopies});
}

Result<void> StoredBlocks::remove() { return streams_->remove(stream_); }

Result<void> StoredBlocks::store(std::uint64_t number, std::string_view block) {
  return streams_->store_patiently(subject_of("block." + std::to_string(number)), block, kPatience);
}

Result<void> StoredBlocks::store(const About& about) {
  return streams_->store_patiently(subject_of("about"), bytes_of(about), kPatience);
}

Result<StoredBlocks::About> StoredBlocks::about() {
  const Result<bool> exists = streams_->has(stream_);
  if (!exists) return exists.error();
  if (!*exists)
    return Error{.what = "the cluster has no session of this name",
                 .where = stream_,
                 .fix = "check the name; when its retention has ended, a session is removed"};
  const Result<std::optional<std::string>> bytes = streams_->newest(stream_, subject_of("about"));
  if (!bytes) return bytes.error();
  if (!*bytes)
    return Error{.what = "the retention of this session has ended, and the cluster has removed it",
                 .where = stream_,
                 .fix = "choose another session"};
  const std::optional<About> about = about_in(**bytes);
  if (!about)
    return Error{.what = "the description of this session is damaged",
                 .where = stream_,
                 .fix = "store the session again under another name"};
  return *about;
}

Result<std::optional<std::string>> StoredBlocks::block(std::uint64_t number) {
  return streams_->newest(stream_, subject_of("block." + std::to_string(number)));
}

Result<std::uint64_t> StoredBlocks::count() {
  const auto subjects = streams_->subjects(stream_, subject_of("block.*"));
  if (!subjects) return subjects.error();
  return std::min<std::uint64_t>(subjects->size(), kMostBlocks);
}

std::uint32_t StoredBlocks::most_block_B() const {
  return static_cast<std::uint32_t>(
      std::clamp<std::size_t>(connection_->most_payload_B(), kLeastBlock_B, kMostBlock_B));
}

}  // namespace telepalp::session_store
