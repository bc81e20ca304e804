#include "support/nats/nats_connection.h"

#include <nats/nats.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "support/nats/refusal.h"

namespace telepalp::nats {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kConnectsWithin = 3s;
constexpr std::chrono::milliseconds kConnectsAgainAfter = 250ms;
constexpr std::chrono::milliseconds kJitter = 250ms;
constexpr std::chrono::milliseconds kWritesWithin = 2s;
constexpr std::chrono::milliseconds kPingEvery = 1s;  // with kMostPings, a server that is gone is noticed within 2 s
constexpr int kMostPings = 2;
constexpr int kMostWaitingNotes = 65536;
constexpr int kMostWaiting_B = 64 << 20;

struct FreeOptions {
  void operator()(natsOptions* options) const noexcept { natsOptions_Destroy(options); }
};
using NatsOptions = std::unique_ptr<natsOptions, FreeOptions>;

std::vector<std::string> split_at_commas(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t comma = 0; comma != list.npos; list.remove_prefix(comma == list.npos ? list.size() : comma + 1)) {
    comma = list.find(',');
    parts.emplace_back(list.substr(0, comma));
  }
  return parts;
}

std::string_view view(const char* text) noexcept { return text == nullptr ? std::string_view() : text; }

}  // namespace

struct NatsConnection::Parts {
  /// Lets a destructor wait until the library has made its last callback, which comes on a thread of the library.
  class LastCall {
   public:
    void came() {
      const std::scoped_lock lock(mutex_);
      came_ = true;
      changed_.notify_all();
    }
    void wait() {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, kWritesWithin, [this] { return came_; });
    }

   private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool came_ = false;
  };

  struct Handler {
    NatsConnection::OnNote on_note;
    LastCall last_call;
  };

  Options options;
  natsConnection* connection = nullptr;
  std::vector<std::pair<natsSubscription*, std::shared_ptr<Handler>>> subscriptions{};

  LastCall closed;
  std::atomic<bool> ends{false};  // a connection that this object closes is not lost

  ~Parts() {
    ends = true;
    for (auto& [subscription, handler] : subscriptions) {
      natsSubscription_Unsubscribe(subscription);
      handler->last_call.wait();
      natsSubscription_Destroy(subscription);
    }
    if (connection == nullptr) return;
    natsConnection_Close(connection);
    closed.wait();  // after the calls of lost() and found()
    natsConnection_Destroy(connection);
  }

  static void lost(natsConnection*, void* closure) { static_cast<Parts*>(closure)->changed(false); }
  static void found(natsConnection*, void* closure) { static_cast<Parts*>(closure)->changed(true); }
  static void over(natsConnection*, void* closure) { static_cast<Parts*>(closure)->closed.came(); }
  static void on_message(natsConnection*, natsSubscription*, natsMsg* message, void* closure) {
    const auto& handler = *static_cast<std::shared_ptr<Handler>*>(closure);
    handler->on_note({.subject = view(natsMsg_GetSubject(message)),
                      .payload = {natsMsg_GetData(message), static_cast<std::size_t>(natsMsg_GetDataLength(message))},
                      .reply_to = view(natsMsg_GetReply(message))});
    natsMsg_Destroy(message);
  }

  static void on_complete(void* closure) {
    const std::unique_ptr<std::shared_ptr<Handler>> handler(static_cast<std::shared_ptr<Handler>*>(closure));
    (*handler)->last_call.came();
  }
  void changed(bool is_connected) const {
    if (options.on_change && !ends) options.on_change(is_connected);
  }
  [[nodiscard]] natsStatus set(natsOptions* to);
};

natsStatus NatsConnection::Parts::set(natsOptions* to) {
  const auto ms = [](std::chrono::milliseconds time) { return static_cast<std::int64_t>(time.count()); };
  const std::vector<std::string> urls = split_at_commas(options.address.url);
  std::vector<const char*> servers;
  for (const std::string& url : urls) servers.push_back(url.c_str());
  natsStatus status = natsOptions_SetServers(to, servers.data(), static_cast<int>(servers.size()));
  const auto then = [&](natsStatus next) {
    if (status == NATS_OK) status = next;
  };
  then(natsOptions_SetNoRandomize(to, true));  // the first server that is named is the nearest one
  then(natsOptions_SetName(to, options.name.c_str()));
  then(natsOptions_SetTimeout(to, ms(kConnectsWithin)));
  then(natsOptions_SetMaxReconnect(to, -1));
  then(natsOptions_SetReconnectWait(to, ms(kConnectsAgainAfter)));
  then(natsOptions_SetReconnectJitter(to, ms(kJitter), ms(kJitter)));
  then(natsOptions_SetReconnectBufSize(to, 0));  // what was not sent is old when the connection is back
  then(natsOptions_SetWriteDeadline(to, ms(kWritesWithin)));
  then(natsOptions_SetPingInterval(to, ms(kPingEvery)));
  then(natsOptions_SetMaxPingsOut(to, kMostPings));
  then(natsOptions_SetDisconnectedCB(to, &Parts::lost, this));
  then(natsOptions_SetReconnectedCB(to, &Parts::found, this));
  then(natsOptions_SetClosedCB(to, &Parts::over, this));
  if (options.writes_at_once) then(natsOptions_SetSendAsap(to, true));
  if (options.address.url.starts_with("tls://")) then(natsOptions_SetSecure(to, true));
  if (!options.address.authority.empty())
    then(natsOptions_LoadCATrustedCertificates(to, options.address.authority.c_str()));
  if (!options.address.credentials.empty())
    then(natsOptions_SetUserCredentialsFromFiles(to, options.address.credentials.c_str(), nullptr));
  return status;
}

NatsConnection::NatsConnection(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
NatsConnection::~NatsConnection() = default;
void* NatsConnection::library_connection() const noexcept { return parts_->connection; }

Result<std::unique_ptr<NatsConnection>> NatsConnection::open(Options options) {
  auto parts = std::make_unique<Parts>();
  parts->options = std::move(options);
  natsOptions* made = nullptr;
  if (const natsStatus status = natsOptions_Create(&made); status != NATS_OK)
    return refused(status, "NATS", "give this computer more memory");
  const NatsOptions held(made);
  const std::string where = without_password(parts->options.address.url);
  if (const natsStatus status = parts->set(made); status != NATS_OK)
    return refused(status, where, "check the address, the credentials file and the authority's certificate");
  if (const natsStatus status = natsConnection_Connect(&parts->connection, made); status != NATS_OK)
    return refused(status, where, "start the NATS server, and check the address and the credentials");
  return std::unique_ptr<NatsConnection>(new NatsConnection(std::move(parts)));
}

Result<void> NatsConnection::subscribe(const std::string& subject, OnNote on_note) {
  auto handler = std::make_shared<Parts::Handler>();
  handler->on_note = std::move(on_note);
  auto closure = std::make_unique<std::shared_ptr<Parts::Handler>>(handler);
  natsSubscription* subscription = nullptr;
  natsStatus status =
      natsConnection_Subscribe(&subscription, parts_->connection, subject.c_str(), &Parts::on_message, closure.get());
  if (status != NATS_OK) return refused(status, subject, "permit this subject in the NATS server's accounts");
  natsSubscription_SetPendingLimits(subscription, kMostWaitingNotes, kMostWaiting_B);
  status = natsSubscription_SetOnCompleteCB(subscription, &Parts::on_complete, closure.release());
  parts_->subscriptions.emplace_back(subscription, std::move(handler));
  if (status == NATS_OK) status = natsConnection_FlushTimeout(parts_->connection, kConnectsWithin.count());
  if (status != NATS_OK) return refused(status, subject, "check the connection with the NATS server");
  return {};
}

bool NatsConnection::publish(const std::string& subject, std::string_view payload) {
  return is_connected() && natsConnection_Publish(parts_->connection, subject.c_str(), payload.data(),
                                                  static_cast<int>(payload.size())) == NATS_OK;
}

Result<std::string> NatsConnection::ask(const std::string& subject, std::string_view payload,
                                        std::chrono::milliseconds time) {
  natsMsg* answer = nullptr;
  const natsStatus status = natsConnection_Request(&answer, parts_->connection, subject.c_str(), payload.data(),
                                                   static_cast<int>(payload.size()), time.count());
  if (status != NATS_OK)
    return refused(status, subject, "start the program that answers this subject, and check the connection");
  std::string text(natsMsg_GetData(answer), static_cast<std::size_t>(natsMsg_GetDataLength(answer)));
  natsMsg_Destroy(answer);
  return text;
}

bool NatsConnection::is_connected() const {
  return natsConnection_Status(parts_->connection) == NATS_CONN_STATUS_CONNECTED;
}

std::size_t NatsConnection::most_payload_B() const {
  return static_cast<std::size_t>(natsConnection_GetMaxPayload(parts_->connection));
}

}  // namespace telepalp::nats
