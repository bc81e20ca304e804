#include "support/nats/streams.h"

#include <nats/nats.h>

#include <utility>

#include "support/nats/refusal.h"

namespace telepalp::nats {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kAnswersWithin = 5s;

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
  jsErrCode code{};
  jsStreamInfo* info = nullptr;
  natsStatus status = js_GetStreamInfo(&info, parts_->context, settings.name.c_str(), nullptr, &code);
  jsStreamInfo_Destroy(info);
  if (status == NATS_NOT_FOUND) status = js_AddStream(nullptr, parts_->context, &config, nullptr, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, settings.name);
  return {};
}

Result<void> Streams::store(const std::string& subject, std::string_view payload) {
  jsErrCode code{};
  const natsStatus status = js_Publish(nullptr, parts_->context, subject.c_str(), payload.data(),
                                       static_cast<int>(payload.size()), nullptr, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, subject);
  return {};
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
  const natsStatus status = js_DirectGetMsg(&message, parts_->context, stream.c_str(), nullptr, &which);
  if (status == NATS_NOT_FOUND) return std::optional<std::string>();
  if (status != NATS_OK) return refused_by_jetstream(status, jsErrCode{}, subject);
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

}  // namespace telepalp::nats
