#include "support/nats/work_queue.h"

#include <nats/nats.h>

#include <optional>
#include <utility>

#include "support/nats/refusal.h"
#include "support/program/repeated_call.h"

namespace telepalp::nats {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kReportsEvery = 3s;  // thrice within kSilence, so that two may be lost
constexpr std::chrono::nanoseconds kIdleConsumerKept = std::chrono::hours(24 * 7);

std::uint64_t deliveries_of(natsMsg* message) {
  jsMsgMetaData* facts = nullptr;
  if (natsMsg_GetMetaData(&facts, message) != NATS_OK) return 1;
  const std::uint64_t count = facts->NumDelivered;
  jsMsgMetaData_Destroy(facts);
  return count;
}

}  // namespace

/// The message, and the thread that reports progress on it.
struct WorkItem::Parts {
  explicit Parts(natsMsg* taken) : message(taken) {}
  ~Parts() {
    progress.reset();
    natsMsg_Destroy(message);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  /// The message, for an answer: no report of progress comes after it.
  [[nodiscard]] natsMsg* for_answer() {
    progress.reset();
    return message;
  }

  natsMsg* message;
  std::optional<program::RepeatedCall> progress{std::in_place, kReportsEvery,
                                                [this] { natsMsg_InProgress(message, nullptr); }};
};

WorkItem::WorkItem(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts)), deliveries_(deliveries_of(parts_->message)) {}
WorkItem::~WorkItem() = default;
WorkItem::WorkItem(WorkItem&&) noexcept = default;
WorkItem& WorkItem::operator=(WorkItem&&) noexcept = default;

std::string_view WorkItem::subject() const noexcept { return natsMsg_GetSubject(parts_->message); }
std::string_view WorkItem::payload() const noexcept {
  return {natsMsg_GetData(parts_->message), static_cast<std::size_t>(natsMsg_GetDataLength(parts_->message))};
}

bool WorkItem::finished() { return natsMsg_AckSync(parts_->for_answer(), nullptr, nullptr) == NATS_OK; }

bool WorkItem::give_back(std::chrono::milliseconds after) {
  return natsMsg_NakWithDelay(parts_->for_answer(), after.count(), nullptr) == NATS_OK;
}

bool WorkItem::remove_as_bad() { return natsMsg_Term(parts_->for_answer(), nullptr) == NATS_OK; }

struct WorkQueue::Parts {
  std::string stream;
  natsSubscription* subscription = nullptr;
  ~Parts() {
    if (subscription == nullptr) return;
    natsSubscription_Unsubscribe(subscription);
    natsSubscription_Destroy(subscription);
  }
};

WorkQueue::WorkQueue(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
WorkQueue::~WorkQueue() = default;

Result<std::unique_ptr<WorkQueue>> WorkQueue::open(const Streams& streams, const std::string& stream,
                                                   const std::string& consumer, const std::string& filter) {
  auto* const context = static_cast<jsCtx*>(streams.library_context());
  jsConsumerConfig config;
  jsConsumerConfig_Init(&config);
  config.Durable = consumer.c_str();
  config.FilterSubject = filter.c_str();
  config.AckPolicy = js_AckExplicit;
  config.AckWait = std::chrono::nanoseconds(kSilence).count();
  config.InactiveThreshold = kIdleConsumerKept.count();
  jsErrCode code{};
  // If the consumer exists with the same settings, this changes nothing.
  natsStatus status = js_AddConsumer(nullptr, context, stream.c_str(), &config, nullptr, &code);
  auto parts = std::make_unique<Parts>();
  parts->stream = stream;
  jsSubOptions bound;
  jsSubOptions_Init(&bound);
  bound.Stream = stream.c_str();
  bound.Consumer = consumer.c_str();
  if (status == NATS_OK)
    status = js_PullSubscribe(&parts->subscription, context, filter.c_str(), consumer.c_str(), nullptr, &bound, &code);
  if (status != NATS_OK) return refused_by_jetstream(status, code, stream);
  return std::unique_ptr<WorkQueue>(new WorkQueue(std::move(parts)));
}

Result<std::optional<WorkItem>> WorkQueue::take(std::chrono::milliseconds patience) {
  natsMsgList list{};
  jsErrCode code{};
  const natsStatus status = natsSubscription_Fetch(&list, parts_->subscription, 1, patience.count(), &code);
  if (status == NATS_TIMEOUT) return std::optional<WorkItem>();
  if (status != NATS_OK) return refused_by_jetstream(status, code, parts_->stream);
  natsMsg* const message = list.Count > 0 ? std::exchange(list.Msgs[0], nullptr) : nullptr;
  natsMsgList_Destroy(&list);
  if (message == nullptr) return std::optional<WorkItem>();
  return std::optional<WorkItem>(WorkItem(std::make_unique<WorkItem::Parts>(message)));
}

}  // namespace telepalp::nats
