#include "support/nats/streams.h"

#include <nats/nats.h>

#include <thread>
#include <utility>

#include "support/nats/refusal.h"

namespace telepalp::nats {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kAnswersWithin = 5s;
constexpr std::chrono::milliseconds kKeepsWithin = 20s;  // all attempts of keep()
constexpr std::chrono::milliseconds kStoresWithin = 1s;  // one attempt of store_patiently()
constexpr std::chrono::milliseconds kAgainAfter = 100ms;

/// True for a failure that ends by itself: the connection is lost, or the cluster has no leader at the moment. Nobody
/// answers for a stream without a leader, and libnats reports this with the code of a server without JetStream.
bool may_pass(natsStatus status, jsErrCode code) {
  if (status == NATS_NO_RESPONDERS) return true;
  if (code == JSClusterNotAvailErr || code == JSClusterNotLeaderErr) return true;
  if (code != jsErrCode{}) return false;
  return status == NATS_TIMEOUT || status == NATS_CONNECTION_DISCONNECTED || status == NATS_INSUFFICIENT_BUFFER ||
         status == NATS_IO_ERROR || status == NATS_NO_SERVER;
}

struct Made {
  natsStatus status = NATS_OK;
  jsErrCode code{};
};

/// Makes the stream unless it is there; with one copy, if the cluster has too few servers for more.
Made make_unless_there(jsCtx* context, jsStreamConfig config) {
  Made made;
  jsStreamInfo* info = nullptr;
  made.status = js_GetStreamInfo(&info, context, config.Name, nullptr, &made.code);
  jsStreamInfo_Destroy(info);
  if (made.status != NATS_NOT_FOUND) return made;
  made.code = {};
  made.status = js_AddStream(nullptr, context, &config, nullptr, &made.code);
  if (made.status == NATS_OK || (made.code != JSStreamReplicasNotSupportedErr && made.code != JSClusterNoPeersErr))
    return made;
  config.Replicas = 1;
  made.code = {};
  made.status = js_AddStream(nullptr, context, &config, nullptr, &made.code);
  return made;
}

}  // namespace

struct Streams::Parts {
  jsCtx* context = nullptr;
  ~Parts() { jsCtx_Destroy(context); }
};

Streams::Streams(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Streams::~Streams() = default;
void* Streams::library_context() const noexcept { return parts_->context; }

Result<std::unique_ptr<Streams>> Streams::open(const NatsConnection& connection) {
  auto parts = std::make_unique<Parts>();
  jsOptions options;
  jsOptions_Init(&options);
  options.Wait = kAnswersWithin.count();
  auto* const library = static_cast<natsConnection*>(connection.library_connection());
  if (const natsStatus status = natsConnection_JetStream(&parts->context, library, &options); status != NATS_OK)
    return refused_by_jetstream(status, jsErrCode{}, "its context");
  return std::unique_ptr<Streams>(new Streams(std::move(parts)));
}

Result<void> Streams::keep(const StreamSettings& settings) {
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  std::vector<const char*> subjects;
  for (const std::string& subject : settings.subjects) subjects.push_back(subject.c_str());
  config.Name = settings.name.c_str();
  config.Subjects = subjects.data();
  config.SubjectsLen = static_cast<int>(subjects.size());
  config.Retention = settings.is_work_queue ? js_WorkQueuePolicy : js_LimitsPolicy;
  config.Discard = js_DiscardNew;
  config.MaxMsgsPerSubject = 1;
  config.MaxAge = std::chrono::nanoseconds(settings.longest_kept).count();
  config.AllowDirect = true;
  config.Replicas = settings.copies;
  const auto until = std::chrono::steady_clock::now() + kKeepsWithin;
  while (true) {
    const Made made = make_unless_there(parts_->context, config);
    if (made.status == NATS_OK) return {};
    const bool no_jetstream = made.status == NATS_NO_RESPONDERS;
    if (no_jetstream || !may_pass(made.status, made.code) || std::chrono::steady_clock::now() >= until)
      return refused_by_jetstream(made.status, made.code, settings.name);
    std::this_thread::sleep_for(kAgainAfter);
  }
}

Result<void> Streams::store(const std::string& subject, std::string_view payload) {
  jsErrCode code{};
  const natsStatus status = js_Publish(nullptr, parts_->context, subject.c_str(), payload.data(),
                                       static_cast<int>(payload.size()), nullptr, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, subject);
  return {};
}

Result<void> Streams::store_patiently(const std::string& subject, std::string_view payload,
                                      std::chrono::milliseconds patience) {
  jsPubOptions options;
  jsPubOptions_Init(&options);
  options.MaxWait = kStoresWithin.count();
  const auto until = std::chrono::steady_clock::now() + patience;
  while (true) {
    jsErrCode code{};
    const natsStatus status = js_Publish(nullptr, parts_->context, subject.c_str(), payload.data(),
                                         static_cast<int>(payload.size()), &options, &code);
    if (status == NATS_OK) return {};
    if (!may_pass(status, code) || std::chrono::steady_clock::now() >= until)
      return refused_by_jetstream(status, code, subject);
    std::this_thread::sleep_for(kAgainAfter);
  }
}

Result<std::vector<std::string>> Streams::subjects(const std::string& stream, const std::string& filter) {
  jsOptions options;
  jsOptions_Init(&options);
  options.Stream.Info.SubjectsFilter = filter.c_str();
  jsStreamInfo* info = nullptr;
  jsErrCode code{};
  const natsStatus status = js_GetStreamInfo(&info, parts_->context, stream.c_str(), &options, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, stream);
  const std::unique_ptr<jsStreamInfo, void (*)(jsStreamInfo*)> held(info, jsStreamInfo_Destroy);
  std::vector<std::string> found;
  if (info->State.Subjects != nullptr)
    for (int i = 0; i < info->State.Subjects->Count; ++i) found.emplace_back(info->State.Subjects->List[i].Subject);
  return found;
}

Result<std::optional<std::string>> Streams::newest(const std::string& stream, const std::string& subject) {
  jsDirectGetMsgOptions which;
  jsDirectGetMsgOptions_Init(&which);
  which.LastBySubject = subject.c_str();
  natsMsg* message = nullptr;
  jsErrCode code{};
  natsStatus status = js_DirectGetMsg(&message, parts_->context, stream.c_str(), nullptr, &which);
  if (status == NATS_NOT_FOUND)  // the server that answered may lag behind the leader
    status = js_GetLastMsg(&message, parts_->context, stream.c_str(), subject.c_str(), nullptr, &code);
  if (status == NATS_NOT_FOUND) return std::optional<std::string>();
  if (status != NATS_OK) return refused_by_jetstream(status, code, subject);
  std::string payload(natsMsg_GetData(message), static_cast<std::size_t>(natsMsg_GetDataLength(message)));
  natsMsg_Destroy(message);
  return std::optional(std::move(payload));
}

Result<void> Streams::erase(const std::string& stream, const std::string& filter) {
  jsOptions options;
  jsOptions_Init(&options);
  options.Stream.Purge.Subject = filter.c_str();
  jsErrCode code{};
  const natsStatus status = js_PurgeStream(parts_->context, stream.c_str(), &options, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, stream);
  return {};
}

Result<void> Streams::remove(const std::string& stream) {
  jsErrCode code{};
  const natsStatus status = js_DeleteStream(parts_->context, stream.c_str(), nullptr, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, stream);
  return {};
}

Result<bool> Streams::has(const std::string& stream) {
  jsErrCode code{};
  jsStreamInfo* info = nullptr;
  const natsStatus status = js_GetStreamInfo(&info, parts_->context, stream.c_str(), nullptr, &code);
  jsStreamInfo_Destroy(info);
  if (status == NATS_NOT_FOUND) return false;
  if (status != NATS_OK) return refused_by_jetstream(status, code, stream);
  return true;
}

}  // namespace telepalp::nats
