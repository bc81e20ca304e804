#include "support/nats/refusal.h"

#include <string_view>

namespace telepalp::nats {
namespace {

constexpr const char* kStartJetStream =
    "start the NATS server with JetStream: nats-server -js, or jetstream {} in its configuration";

/// What libnats adds to the text of `status`, without the place in its own source, "(conn.c:2088): ", which means
/// nothing to a user.
std::string detail_of(natsStatus status) {
  const char* const last = nats_GetLastError(nullptr);
  std::string_view text = last == nullptr ? "" : last;
  if (const std::size_t end = text.find("): "); text.starts_with("(") && end != text.npos) text.remove_prefix(end + 3);
  return text.empty() || text == natsStatus_GetText(status) ? "" : ": " + std::string(text);
}

std::string fix_of(natsStatus status, jsErrCode code) {
  switch (code) {
    case JSInsufficientResourcesErr:
    case JSMemoryResourcesExceededErr:
    case JSStorageResourcesExceededErr:
    case JSAccountResourcesExceededErr:
    case JSStreamStoreFailedErr:
      return "JetStream is full: give it more room (max_file_store in the NATS server's configuration)";
    case JSNotEnabledErr:
    case JSNotEnabledForAccountErr:
      return kStartJetStream;
    default:
      break;
  }
  if (status == NATS_NO_RESPONDERS) return kStartJetStream;
  if (status == NATS_TIMEOUT)
    return "check that the NATS servers reach each other, and that this account may use JetStream ($JS.API.>)";
  return "check the connection with the NATS server, and its log";
}

}  // namespace

Error refused(natsStatus status, const std::string& where, const std::string& fix) {
  return {.what = natsStatus_GetText(status) + detail_of(status), .where = where, .fix = fix};
}

Error refused_by_jetstream(natsStatus status, jsErrCode code, const std::string& about) {
  return refused(status, "JetStream, " + about, fix_of(status, code));
}

}  // namespace telepalp::nats
