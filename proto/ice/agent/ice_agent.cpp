#include "proto/ice/agent/ice_agent.h"

#include <nice/agent.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/post.hpp>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>

#include "proto/ice/agent/glib_loop.h"

namespace telepalp::ice {
namespace {

constexpr guint kComponent = 1;
constexpr int kSocketBuffer_B = 4 << 20;
constexpr int kMostWaiting = 4096;  // received datagrams that the executor has not taken
/// The type preference that libnice gives a relayed candidate whose relay is reached by UDP; by TCP it gives less.
constexpr std::uint32_t kRelayByUdpPreference = 30;

template <class Pointer>
struct Freed {
  void operator()(Pointer* pointer) const noexcept {
    if constexpr (std::is_same_v<Pointer, NiceCandidate>)
      nice_candidate_free(pointer);
    else
      g_free(pointer);
  }
};
using OwnCandidate = std::unique_ptr<NiceCandidate, Freed<NiceCandidate>>;
using OwnText = std::unique_ptr<gchar, Freed<gchar>>;

std::optional<Candidate::Kind> kind_of(NiceCandidateType type) noexcept {
  switch (type) {
    case NICE_CANDIDATE_TYPE_HOST:
      return Candidate::Kind::Host;
    case NICE_CANDIDATE_TYPE_SERVER_REFLEXIVE:
      return Candidate::Kind::Reflexive;
    case NICE_CANDIDATE_TYPE_RELAYED:
      return Candidate::Kind::Relayed;
    case NICE_CANDIDATE_TYPE_PEER_REFLEXIVE:
      break;
  }
  return std::nullopt;
}

NiceCandidateType type_of(Candidate::Kind kind) noexcept {
  switch (kind) {
    case Candidate::Kind::Host:
      return NICE_CANDIDATE_TYPE_HOST;
    case Candidate::Kind::Reflexive:
      return NICE_CANDIDATE_TYPE_SERVER_REFLEXIVE;
    case Candidate::Kind::Relayed:
      break;
  }
  return NICE_CANDIDATE_TYPE_RELAYED;
}

std::optional<Candidate> candidate_of(const NiceCandidate& own) {
  const std::optional<Candidate::Kind> kind = kind_of(own.type);
  if (!kind || own.transport != NICE_CANDIDATE_TRANSPORT_UDP) return std::nullopt;
  std::array<gchar, NICE_ADDRESS_STRING_LEN> text{};
  nice_address_to_string(&own.addr, text.data());
  boost::system::error_code failed;
  Candidate candidate{.foundation = static_cast<const char*>(own.foundation),
                      .priority = own.priority,
                      .address = boost::asio::ip::make_address(text.data(), failed),
                      .port = static_cast<std::uint16_t>(nice_address_get_port(&own.addr)),
                      .kind = *kind};
  return failed ? std::nullopt : std::optional(std::move(candidate));
}

PathKind kind_of(const NiceCandidate& local, const NiceCandidate& remote) noexcept {
  PathKind kind = PathKind::Direct;
  for (const NiceCandidate* const end : {&local, &remote}) {
    PathKind of_end = PathKind::Punched;
    if (end->type == NICE_CANDIDATE_TYPE_HOST) of_end = PathKind::Direct;
    if (end->type == NICE_CANDIDATE_TYPE_RELAYED)
      of_end = end->priority >> 24U >= kRelayByUdpPreference ? PathKind::RelayedByUdp : PathKind::RelayedByTcp;
    kind = std::max(kind, of_end);
  }
  return kind;
}

}  // namespace

/// What libnice's callbacks share with the agent. They run on the thread of GlibLoop, or within a call of libnice.
struct IceAgent::State : std::enable_shared_from_this<State> {
  State(boost::asio::any_io_executor on, Reach far) : executor(std::move(on)), reach(far) {}

  /// Lets the executor call `work` with the handlers, unless the agent is destroyed before.
  template <class Work>
  void tell(Work work) {
    // The lock keeps the executor's io_context, which may end after the agent is destroyed, out of use from then on.
    const std::lock_guard lock(closing);
    if (closed) return;
    boost::asio::post(executor, [weak = weak_from_this(), work = std::move(work)] {
      if (const std::shared_ptr<State> self = weak.lock(); self && !self->closed) work(*self);
    });
  }
  void set_up(const Options& options);
  void widen_sockets() const;
  void received(std::span<const std::byte> datagram);
  void end();

  boost::asio::any_io_executor executor;
  Reach reach;
  Handlers handlers{};  // used on the executor
  std::mutex closing;
  std::atomic<bool> closed{false};
  std::atomic<int> waiting{0};
  NiceAgent* agent = nullptr;
  guint stream = 0;
};

void IceAgent::State::received(std::span<const std::byte> datagram) {
  if (waiting.fetch_add(1) >= kMostWaiting) {
    --waiting;
    return;  // the executor is too slow: a lost datagram
  }
  tell([bytes = std::vector<std::byte>(datagram.begin(), datagram.end())](State& self) {
    --self.waiting;
    self.handlers.on_datagram(bytes);
  });
}

void IceAgent::State::set_up(const Options& options) {
  g_object_set(agent, "controlling-mode", static_cast<gboolean>(options.controlling), "upnp", FALSE, "ice-tcp", FALSE,
               "ice-udp", TRUE, nullptr);
  const auto by_udp = std::ranges::find_if(options.relays, [](const Relay& relay) { return relay.port != 0; });
  if (by_udp != options.relays.end())
    g_object_set(agent, "stun-server", by_udp->address.c_str(), "stun-server-port", guint{by_udp->port}, nullptr);
  stream = nice_agent_add_stream(agent, 1);
  for (const Relay& relay : options.relays) {
    const auto use = [&](std::uint16_t port, NiceRelayType type) {
      if (port != 0)
        nice_agent_set_relay_info(agent, stream, kComponent, relay.address.c_str(), port, relay.user.c_str(),
                                  relay.password.c_str(), type);
    };
    use(relay.port, NICE_RELAY_TYPE_TURN_UDP);
    use(relay.tcp_port, NICE_RELAY_TYPE_TURN_TCP);
  }
  nice_agent_set_stream_tos(agent, stream, options.type_of_service);
  if (options.reach == Reach::Loopback) {
    NiceAddress loopback{};
    nice_address_set_from_string(&loopback, "127.0.0.1");
    nice_agent_add_local_address(agent, &loopback);
  }
  const auto connect = [this](const char* signal, GCallback callback) {
    g_signal_connect(agent, signal, callback, this);
  };
  connect("new-candidate-full", G_CALLBACK(+[](NiceAgent*, NiceCandidate* found, State* self) {
            std::optional<Candidate> candidate = candidate_of(*found);
            if (candidate && may_check(candidate->address, self->reach))
              self->tell([one = std::move(*candidate)](State& told) { told.handlers.on_candidate(one); });
          }));
  connect("candidate-gathering-done", G_CALLBACK(+[](NiceAgent*, guint, State* self) {
            self->tell([](State& told) { told.handlers.on_all_candidates(); });
          }));
  connect("new-selected-pair-full",
          G_CALLBACK(+[](NiceAgent*, guint, guint, NiceCandidate* local, NiceCandidate* remote, State* self) {
            self->tell([kind = kind_of(*local, *remote)](State& told) { told.handlers.on_path(kind); });
          }));
  connect("component-state-changed", G_CALLBACK(+[](NiceAgent*, guint, guint, guint state, State* self) {
            if (state == NICE_COMPONENT_STATE_FAILED) self->tell([](State& told) { told.handlers.on_failed(); });
          }));
  nice_agent_attach_recv(
      agent, stream, kComponent, GlibLoop::of_process().context(),
      [](NiceAgent*, guint, guint, guint length, gchar* bytes, gpointer self) {
        static_cast<State*>(self)->received(std::as_bytes(std::span(bytes, length)));
      },
      this);
}

/// A burst of images must fit.
void IceAgent::State::widen_sockets() const {
  GPtrArray* const sockets = nice_agent_get_sockets(agent, stream, kComponent);
  if (sockets == nullptr) return;
  for (guint i = 0; i < sockets->len; ++i) {
    const int fd = g_socket_get_fd(static_cast<GSocket*>(g_ptr_array_index(sockets, i)));
    (void)::setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &kSocketBuffer_B, sizeof kSocketBuffer_B);
    (void)::setsockopt(fd, SOL_SOCKET, SO_SNDBUF, &kSocketBuffer_B, sizeof kSocketBuffer_B);
  }
  g_ptr_array_unref(sockets);
}

/// Gives the relays' allocations back, and then ends the agent. This object lives until then.
void IceAgent::State::end() {
  GlibLoop::of_process().run([self = shared_from_this()] {
    nice_agent_attach_recv(self->agent, self->stream, kComponent, GlibLoop::of_process().context(), nullptr, nullptr);
    nice_agent_close_async(
        self->agent,
        [](GObject* ended, GAsyncResult*, gpointer kept) {
          g_object_unref(ended);
          delete static_cast<std::shared_ptr<State>*>(kept);
          GlibLoop::of_process().agent_has_ended();
        },
        new std::shared_ptr<State>(self));
  });
}

Result<std::unique_ptr<IceAgent>> IceAgent::start(const boost::asio::any_io_executor& executor, const Options& options,
                                                  Handlers handlers) {
  GlibLoop& loop = GlibLoop::of_process();
  auto state = std::make_shared<State>(executor, options.reach);
  state->handlers = std::move(handlers);
  state->agent = nice_agent_new_full(
      loop.context(), NICE_COMPATIBILITY_RFC5245,
      static_cast<NiceAgentOption>(NICE_AGENT_OPTION_ICE_TRICKLE | NICE_AGENT_OPTION_CONSENT_FRESHNESS));
  loop.agent_begins();
  state->set_up(options);
  std::unique_ptr<IceAgent> agent(new IceAgent(state));
  gchar *user = nullptr, *password = nullptr;
  if (nice_agent_get_local_credentials(state->agent, state->stream, &user, &password) == FALSE ||
      nice_agent_gather_candidates(state->agent, state->stream) == FALSE)
    return Error{.what = "no UDP socket can be opened to look for a path",
                 .where = "ICE",
                 .fix = "none is needed: images and touch go over TCP"};
  agent->credentials_ = {.user = OwnText(user).get(), .password = OwnText(password).get()};
  state->widen_sockets();
  return agent;
}

IceAgent::IceAgent(std::shared_ptr<State> state) : state_(std::move(state)) {}

IceAgent::~IceAgent() {
  {
    const std::lock_guard lock(state_->closing);
    state_->closed = true;
  }
  state_->handlers = {};
  state_->end();
}

void IceAgent::set_peer(const Credentials& peer) {
  (void)nice_agent_set_remote_credentials(state_->agent, state_->stream, peer.user.c_str(), peer.password.c_str());
}

void IceAgent::add(const Candidate& candidate) {
  const OwnCandidate one(nice_candidate_new(type_of(candidate.kind)));
  one->component_id = kComponent;
  one->stream_id = state_->stream;
  one->transport = NICE_CANDIDATE_TRANSPORT_UDP;
  one->priority = candidate.priority;
  (void)candidate.foundation.copy(static_cast<char*>(one->foundation), NICE_CANDIDATE_MAX_FOUNDATION - 1);
  if (nice_address_set_from_string(&one->addr, candidate.address.to_string().c_str()) == FALSE) return;
  nice_address_set_port(&one->addr, candidate.port);
  one->base_addr = one->addr;
  GSList* const list = g_slist_prepend(nullptr, one.get());
  (void)nice_agent_set_remote_candidates(state_->agent, state_->stream, kComponent, list);
  g_slist_free(list);
}

bool IceAgent::send(std::span<const std::byte> datagram) {
  GOutputVector vector{.buffer = datagram.data(), .size = datagram.size()};
  const NiceOutputMessage message{.buffers = &vector, .n_buffers = 1};
  GError* failed = nullptr;
  const gint sent =
      nice_agent_send_messages_nonblocking(state_->agent, state_->stream, kComponent, &message, 1, nullptr, &failed);
  const bool is_full = sent == 0 || (failed != nullptr && g_error_matches(failed, G_IO_ERROR, G_IO_ERROR_WOULD_BLOCK));
  g_clear_error(&failed);
  return !is_full;
}

}  // namespace telepalp::ice
