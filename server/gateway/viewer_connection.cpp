#include "server/gateway/viewer_connection.h"

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "proto/keys/audit_text.h"
#include "server/gateway/foxglove/playback_control.h"
#include "server/gateway/foxglove_protocol.h"
#include "server/gateway/viewer_commands.h"
#include "server/gateway/visit.h"
#include "server/gateway/voice/viewer_voice.h"

namespace telepalp::gateway {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;

constexpr std::size_t kMaxTextBytes = 65'536;  // of a client's message; a larger one closes with code 1009
constexpr std::size_t kMaxSubscriptions = 256;
constexpr std::size_t kMaxWaitingTexts = 32;
constexpr std::string_view kSubscriberName = "viewer";
constexpr std::string_view kUnopened = "the recorded session is not opened: ";  // the page looks for these words
/// Minimum time between two warnings that no station uses the hand; a viewer publishes it 100 times a second.
constexpr std::chrono::seconds kUntakenWarnedEvery{1};
/// Limits the age of a frame at a slow viewer: a message in the kernel's buffer cannot be replaced by a newer one.
constexpr int kSendBufferBytes = 256 * 1024;

std::string to_text(const tcp::endpoint& peer) {
  std::ostringstream text;
  text << peer;
  return text.str();
}

class ViewerConnection final : public Connection, public std::enable_shared_from_this<ViewerConnection> {
 public:
  ViewerConnection(WebStream stream, const Newcomer& newcomer, std::shared_ptr<GatewayContext> context)
      : Connection(std::move(context)),
        stream_(std::move(stream)),
        visitor_(newcomer.visitor),
        reading_(newcomer.reading) {}
  ~ViewerConnection() override { leave(); }

  void start(const HttpRequest& upgrade, const Newcomer& newcomer) {
    const std::string_view subprotocol = newcomer.subprotocol;
    speaks_playback_ = subprotocol == foxglove::kSubprotocols.front();
    beast::error_code ignored;
    socket().set_option(tcp::no_delay(true), ignored);
    socket().set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
    stream_.read_message_max(kMaxTextBytes);
    stream_.next_layer().limit_fragments();
    stream_.auto_fragment(false);
    stream_.set_option(
        websocket::stream_base::timeout{context()->options.request_timeout, context()->options.idle_timeout, true});
    stream_.set_option(websocket::stream_base::decorator([subprotocol](websocket::response_type& reply) {
      reply.set(beast::http::field::sec_websocket_protocol, beast::string_view(subprotocol.data(), subprotocol.size()));
    }));
    stream_.async_accept(upgrade, [self = shared_from_this(), name = to_text(newcomer.peer)](beast::error_code failed) {
      if (failed) return;
      self->name_ = name;
      self->greet_when_ready();
      self->read();
    });
  }

  [[nodiscard]] bool is_idle() const override { return subscriber_ && subscriptions_.empty() && !holds_hand_; }

  void check_access() override {
    if (!visitor_) return;
    const bool signed_out =
        !visitor_->cookie.empty() && !context()->sessions.find(visitor_->cookie, std::chrono::steady_clock::now());
    if (signed_out || !context()->options.access->still_holds(visitor_->who)) close();
  }

  void send_playback_state() override {
    if (controls_playback_ && subscriber_) say_binary(foxglove::playback_state(offer().playback.state()));
  }

  void offer_changed() override {
    if (reading_ || !subscriber_) return;
    controls_playback_ = controls_playback_ && offer().playback;
    advertise_states();
  }

  void look_at_own_states() override {
    if (subscriber_ && !reading_ && holds_hand_ && !context()->holder.holds(*subscriber_)) lost_hand_in_silence();
    if (!reading_) return;
    reading_->states().look();
    if (is_opening_ && !reading_is_opening()) reading_opened();
  }

  void close() override {
    leave();
    beast::error_code ignored;
    socket().close(ignored);
  }

 private:
  tcp::socket& socket() { return beast::get_lowest_layer(stream_).socket(); }

  /// What this viewer may subscribe to.
  hub::Hub& hub() { return reading_ ? reading_->hub() : context()->hub; }
  hub::Hub& views() { return reading_ ? reading_->views() : context()->views; }
  const origin::Offer& offer() { return reading_ ? reading_->offer() : context()->options.offer; }
  origin::StatePublisher& states() { return reading_ ? reading_->states() : *context()->states; }

  bool may(keys::Operation operation) {
    return visitor_ && context()->options.access->may(visitor_->who, operation).ok();
  }

  /// Moving a played session changes what all viewers see; a reading is its reader's own.
  bool may_change(const ResourceRow& row) { return may(reading_ ? row.change_own : row.change); }

  std::string paths_to_change() {
    std::string paths;
    for (const ResourceRow& row : all_resources())
      if (may_change(row)) paths += (paths.empty() ? "" : ",") + std::string(row.path);
    return paths;
  }

  /// True unless `topic` is the state of a resource that this client may not read, or that the server does not have, or
  /// what is said, to which this visitor may not listen.
  bool is_offered(const wire::Topic& topic) {
    if (topic.spoken) return may(keys::Operation::Listen);
    return resource_at(topic.name) == nullptr || offered_.contains(topic.name);
  }

  void subscriptions_changed() {
    if (reading_) reading_->subscriptions_changed();
    if (context()->view_maker) context()->view_maker->subscriptions_changed();
  }

  void leave() {
    if (!subscriber_) return;
    const hub::SubscriberId viewer = *subscriber_;
    subscriber_.reset();
    context()->options.access->leave(stream_number_, "viewer=" + std::to_string(number_));
    hub().leave(viewer);
    views().leave(views_subscriber_);
    if (context()->view_maker) context()->view_maker->subscriptions_changed();
    if (std::exchange(reading_, nullptr)) return;  // its last holder ends it
    context()->holder.let_go(viewer);
    context()->options.patient_floor->leave(viewer);
    context()->doctor_floor.leave(viewer);
    note_hand(false, "why=\"the connection ended\"");
    publish_holder();
  }

  [[nodiscard]] bool reading_is_opening() const {
    return reading_ && reading_->state().phase() == msg::ReadingState::PHASE_OPENING;
  }

  /// A client that controls the playback learns of the session from the greeting, so that it waits for the session.
  void greet_when_ready() {
    is_opening_ = reading_is_opening();
    if (!is_opening_ || !speaks_playback_) greet();
    if (!is_opening_) tell_why_unopened();
  }

  /// The session of this client's reading was opened, or cannot be opened.
  void reading_opened() {
    is_opening_ = false;
    if (subscriber_)
      advertise_states();
    else
      greet();
    tell_why_unopened();
  }

  /// Tells the client of the resources that have come or gone since it was told last.
  void advertise_states() {
    const std::set<std::string_view> before = std::exchange(offered_, offered_now());
    const auto has_gone = [&](const wire::Topic& topic) {
      return before.contains(topic.name) && !offered_.contains(topic.name);
    };
    const auto has_come = [&](const wire::Topic& topic) {
      return offered_.contains(topic.name) && !before.contains(topic.name);
    };
    std::erase_if(subscriptions_,
                  [&](const auto& one) { return before.contains(one.second) && !offered_.contains(one.second); });
    say(foxglove::unadvertise(has_gone));
    say(foxglove::advertise(has_come));
  }

  /// The paths of the resources that the server has, and that this visitor may read.
  std::set<std::string_view> offered_now() {
    std::set<std::string_view> paths;
    for (const ResourceRow& row : all_resources())
      if (may(row.read) && offer().resources.contains(row.path)) paths.insert(row.path);
    return paths;
  }

  void tell_why_unopened() {
    if (reading_ && !reading_->state().problem().empty()) warn(std::string(kUnopened) + reading_->state().problem());
  }

  void greet() {
    if (!socket().is_open()) return;  // the gateway was closed meanwhile; the hub may be destroyed
    subscriber_ = hub().join(std::string(kSubscriberName), name_, [this] { write_next(); });
    hub().note_shows_images(*subscriber_);
    number_ = *subscriber_;
    if (visitor_)
      stream_number_ = context()->options.access->enter(visitor_->who, "browser", name_,
                                                        "viewer=" + std::to_string(number_) +
                                                            (visitor_->cookie.empty() ? " by=token" : " by=cookie") +
                                                            (reading_ ? " what=\"a recorded session\"" : ""));
    views_subscriber_ = views().join(std::string(kSubscriberName), name_, [this] { write_next(); });
    const std::string_view role = visitor_ ? keys::name(visitor_->who.role) : std::string_view{};
    controls_playback_ = speaks_playback_ && offer().playback && may_change(*resource_at(origin::kPlayback.topic.name));
    const auto played = controls_playback_ ? std::optional(offer().playback.state()) : std::nullopt;
    say(foxglove::server_info(context()->options.server_name, context()->session_id, *subscriber_, role, played,
                              paths_to_change()));
    offered_ = offered_now();
    say(foxglove::advertise([this](const wire::Topic& topic) { return is_offered(topic); }));
    send_playback_state();
  }

  void read() {
    stream_.async_read(incoming_, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed)
        return self->leave();  // the client closed, or Beast closed with code 1009 because of a too large message
      self->handle(beast::buffers_to_string(self->incoming_.data()));
      self->incoming_.consume(self->incoming_.size());
      self->read();
    });
  }

  void handle(const std::string& message) {
    if (!subscriber_) return;
    if (!stream_.got_text()) return foxglove::is_playback_request(message) ? move_playback(message) : publish(message);
    const Result<foxglove::Request> request = foxglove::read_request(message);
    if (!request) return warn(to_string(request.error()));
    for (const std::uint32_t id : request->unsubscribe) subscriptions_.erase(id);
    for (const auto& wanted : request->subscribe) subscribe(wanted);
    for (const std::uint32_t id : request->unadvertise) commands_.unadvertise(id);
    for (const auto& channel : request->advertise)
      if (const Result<void> taken = commands_.advertise(channel); !taken) warn(to_string(taken.error()));
    std::vector<std::string> topics;
    for (const auto& [id, topic] : subscriptions_) topics.emplace_back(topic);
    states().expect_subscriber(topics);
    hub().subscribe(*subscriber_, topics);
    views().subscribe(views_subscriber_, topics);
    subscriptions_changed();
  }

  void move_playback(const std::string& bytes) {
    const origin::PlaybackPort& port = offer().playback;
    if (!port) return warn(std::string(kNoSession));
    if (!controls_playback_) return warn(std::string(kOnlyForPlayers));
    const msg::PlaybackState before = port.state();
    const Result<foxglove::PlaybackRequest> request = foxglove::read_playback_request(bytes, before);
    if (!request) return warn(to_string(request.error()));
    const Result<void> moved = port.move(foxglove::command_of(*request, before));
    if (!moved) return warn(to_string(moved.error()));
    states().commanded();
    say_binary(foxglove::playback_reply(before, *request));
  }

  void publish_holder() {
    const SessionTime now = context()->now();
    if (const std::optional<msg::HandHolder> news = context()->holder.news(now))
      context()->hub.publish(wire::make_message(wire::kHandHolder, now, *news));
  }

  /// Whether this viewer may hold the hand. The first attempt of one that may not is written to the audit log.
  bool may_touch() {
    const Result<void> may = visitor_ ? context()->options.access->may(visitor_->who, keys::Operation::Touch)
                                      : Error{.what = "nobody is signed in", .where = {}, .fix = {}};
    if (!may && !std::exchange(denied_, true)) {
      context()->options.access->note(access::AuditEvent::Refused, whose(),
                                      "program=browser why=" + keys::audit_text(may.error().what));
      warn(may.error().what + ". fix: sign in with a doctor's token");
    }
    return may.ok();
  }

  void publish(const std::string& bytes) {
    if (reading_) return;  // its picture is of the past, and no station follows a hand there
    if (const auto words = commands_.spoken(bytes)) return speak(words->topic, words->payload);
    if (!may_touch()) return;
    if (commands_.lets_go(bytes)) {
      context()->holder.let_go(*subscriber_);
      note_hand(false);
      return publish_holder();
    }
    if (const auto to = commands_.hands_over_to(bytes)) return hand_over(*to);
    if (commands_.asks_to_rearm(bytes)) return rearm();
    if (commands_.accepts_object(bytes)) return accept_object();
    const auto message = commands_.hear(bytes, *subscriber_, context()->now());
    if (!message) return warn(to_string(message.error()));
    if (!*message) return;
    if (!context()->hub.is_taken((*message)->topic.name, kSubscriberName)) warn_untaken();
    const bool holds = context()->holder.moves(*subscriber_, context()->now(), is_own_station());
    if (!holds && !is_own_station()) warn_of_another_doctors_station();
    note_hand(holds);
    if (holds) context()->hub.publish(**message);
    publish_holder();
  }

  voice::VoiceFloor& floor_of(const wire::Topic& topic) {
    return topic.name == wire::kDoctorVoice.name ? context()->doctor_floor : *context()->options.patient_floor;
  }

  /// Passes on what the visitor says, if it may speak there and nobody else does.
  void speak(const wire::Topic& topic, const std::string& payload) {
    const SessionTime now = context()->now();
    const auto refuse = [this](std::string_view why) { voice_.refuse(why, [this](const auto& text) { warn(text); }); };
    if (!may(operation_to_speak(topic))) return refuse(kMayNotSpeak);
    if (offer().playback) return refuse(kPlayedSession);
    std::optional<wire::Message> message = voice_.hear(topic, payload, *subscriber_, now);
    if (!message) return refuse(kNotSpeech);
    if (!floor_of(topic).speaks(*subscriber_, now)) return refuse(kAnotherSpeaks);
    context()->hub.publish(std::move(*message));
  }

  void rearm() {
    msg::ViewerHand asked;
    asked.set_rearm(true);
    ask_station(asked, access::AuditEvent::Rearmed,
                "the station is not re-armed: another viewer holds the hand. fix: ask that viewer to re-arm");
  }

  void accept_object() {
    msg::ViewerHand asked;
    asked.set_accept_object(true);
    ask_station(asked, access::AuditEvent::AcceptedObject,
                "the object is not accepted as skin: another viewer holds the hand. fix: ask that viewer to accept it");
  }

  /// Passes `asked` on to the station that follows the hand of a viewer. A station of another tracker does not hear of
  /// it: a person holds its device, and only its own operator sees that person.
  void ask_station(msg::ViewerHand asked, access::AuditEvent event, const std::string& not_holding) {
    if (!context()->holder.may_command(*subscriber_, is_own_station())) return warn(not_holding);
    if (!context()->hub.is_taken(wire::kViewerHand.name, kSubscriberName)) return warn_untaken();
    asked.set_viewer(*subscriber_);
    context()->hub.publish(wire::make_message(wire::kViewerHand, context()->now(), asked));
    note(event);
  }

  void hand_over(std::uint64_t to) {
    const access::Access& access = *context()->options.access;
    if (const Result<void> may = access.may(visitor_->who, keys::Operation::HandOver); !may)
      return warn(to_string(may.error()));
    if (!context()->holder.hand_over(*subscriber_, to, context()->now()))
      return warn(
          "the viewer hand is not handed over: this viewer does not hold the hand, or the named viewer has not asked "
          "for the hand in the last 3 s. fix: take the hand first, and name a viewer that asks for the hand");
    note_hand(false, "to=\"viewer " + std::to_string(to) + "\"");
    publish_holder();
  }

  /// Writes to the audit log when this viewer gets or gives up the hand.
  void note_hand(bool holds, const std::string& more = {}) {
    if (std::exchange(holds_hand_, holds) == holds) return;
    note(holds ? access::AuditEvent::TookTouch : access::AuditEvent::GaveTouch, more);
  }

  void lost_hand_in_silence() {
    note_hand(false, "why=\"the browser was silent for 2 s\"");
    publish_holder();
  }

  [[nodiscard]] std::optional<keys::Identity> whose() const {
    return visitor_ ? std::optional(visitor_->who) : std::nullopt;
  }

  /// Writes to the audit log what this viewer did.
  void note(access::AuditEvent event, const std::string& more = {}) {
    context()->options.access->note(
        event, whose(),
        "program=browser viewer=" + std::to_string(number_) + " from=" + name_ + (more.empty() ? "" : " " + more));
  }

  /// False: the station that follows the hand is another doctor's. This viewer may move it only after that doctor's
  /// page has handed the hand over.
  bool is_own_station() {
    const auto holder = context()->options.access->touch().holder(std::chrono::steady_clock::now());
    return !holder || (visitor_ && visitor_->who.name == *holder);
  }

  void warn_of_another_doctors_station() {
    if (!std::exchange(told_whose_station_, true))
      warn(
          "the station is another doctor's: only this doctor's page moves it. fix: ask that doctor to hand the hand "
          "over "
          "to this page");
  }

  void warn_untaken() {
    const SessionTime now = context()->now();
    if (untaken_warned_ && now - *untaken_warned_ < kUntakenWarnedEvery) return;
    untaken_warned_ = now;
    warn(  // the page looks for the words "follows the hand of a viewer"
        "no connected station follows the hand of a viewer. fix: start telepalp-station --tracker browser, or "
        "deploy/demo --hand browser");
  }

  void subscribe(const foxglove::Request::Subscription& wanted) {
    const std::optional<wire::Topic> topic = foxglove::topic_of_channel(wanted.channel);
    if (!topic || !is_offered(*topic))
      return warn("there is no channel " + std::to_string(wanted.channel) +
                  ". fix: subscribe to an advertised channel");
    if (subscriptions_.size() >= kMaxSubscriptions)
      return warn("this viewer has " + std::to_string(kMaxSubscriptions) +
                  " subscriptions already, as many as it may have. fix: unsubscribe from a topic first");
    if (!subscriptions_.emplace(wanted.id, topic->name).second)
      warn("the subscription id " + std::to_string(wanted.id) + " is in use. fix: choose another id");
  }

  void warn(const std::string& text) { say(foxglove::status(foxglove::Level::Warning, text)); }

  /// Queues a text. A viewer that sends invalid requests faster than it reads the replies gets only some of them.
  void say(std::string text) { put_in_line({std::move(text), true}); }
  void say_binary(std::string bytes) { put_in_line({std::move(bytes), false}); }

  struct Said {
    std::string content;
    bool is_text;
  };
  void put_in_line(Said said) {
    if (said_.size() >= kMaxWaitingTexts) return;
    said_.push_back(std::move(said));
    write_next();
  }

  void write_next() {
    if (writing_) return;
    if (!said_.empty()) return write_said();
    while (subscriber_) {
      std::optional<wire::Message> message = next_message();
      if (!message) return;
      if (start_message(std::move(*message))) return write_message();
    }
  }

  /// Takes messages alternately from telepalp's topics and from the view topics, so that neither blocks the other.
  std::optional<wire::Message> next_message() {
    view_is_next_ = !view_is_next_;
    std::optional<wire::Message> message = view_is_next_ ? views().next(views_subscriber_) : hub().next(*subscriber_);
    if (message) return message;
    return view_is_next_ ? hub().next(*subscriber_) : views().next(views_subscriber_);
  }

  /// Prepares to write `message` to each subscription of its topic; false if the client has unsubscribed meanwhile.
  bool start_message(wire::Message message) {
    for (const auto& [id, topic] : subscriptions_)
      if (topic == message.topic.name) to_.push_back(id);
    message_ = std::move(message);
    return !to_.empty();
  }

  void write_said() {
    writing_ = true;
    stream_.text(said_.front().is_text);
    stream_.async_write(asio::buffer(said_.front().content),
                        [self = shared_from_this()](beast::error_code failed, std::size_t) {
                          if (failed) return self->leave();
                          self->said_.pop_front();
                          self->writing_ = false;
                          self->write_next();
                        });
  }

  void write_message() {
    writing_ = true;
    header_ = foxglove::message_header(to_.front(), message_->published);
    stream_.binary(true);
    const std::array<asio::const_buffer, 2> parts{asio::buffer(header_), asio::buffer(*message_->payload)};
    stream_.async_write(parts, [self = shared_from_this()](beast::error_code failed, std::size_t) {
      if (failed) return self->leave();
      self->to_.pop_front();
      if (!self->to_.empty()) return self->write_message();
      self->message_.reset();
      self->writing_ = false;
      self->write_next();
    });
  }

  websocket::stream<WebStream> stream_;
  std::optional<Visitor> visitor_;
  std::shared_ptr<origin::Reading> reading_;  // null: this viewer sees what the server publishes for all
  bool is_opening_ = false;                   // the reading's session was being opened when we looked last
  std::set<std::string_view> offered_;        // paths of the resources that the client knows of
  std::string name_;                          // address of the peer
  bool denied_ = false;
  bool told_whose_station_ = false;
  std::uint64_t stream_number_ = 0;  // in access::People
  bool holds_hand_ = false;
  hub::SubscriberId number_ = 0;    // of this viewer, also after it has left
  bool speaks_playback_ = false;    // clients of the older subprotocol fail on binary messages that they do not know
  bool controls_playback_ = false;  // the visitor may control the played session, by this connection
  beast::flat_buffer incoming_;     // bounded by read_message_max
  std::optional<hub::SubscriberId> subscriber_;  // set from the handshake until the end
  hub::SubscriberId views_subscriber_ = 0;       // valid while subscriber_ is set
  bool view_is_next_ = false;
  std::map<std::uint32_t, std::string_view> subscriptions_;  // id -> topic, a name in one of the tables of topics
  ViewerCommands commands_;
  ViewerVoice voice_;
  std::optional<SessionTime> untaken_warned_;
  std::deque<Said> said_;  // replies and playback states, to write before messages of topics
  bool writing_ = false;
  std::optional<wire::Message> message_;  // the message that is being written
  std::deque<std::uint32_t> to_;          // subscriptions to which the message is still to be written
  std::array<std::uint8_t, foxglove::kMessageHeaderBytes> header_{};
};

}  // namespace

void start_viewer_connection(WebStream stream, const HttpRequest& upgrade, const Newcomer& newcomer,
                             std::shared_ptr<GatewayContext> context) {
  // shared: the connection is owned by the pending reads and writes
  std::make_shared<ViewerConnection>(std::move(stream), newcomer, std::move(context))->start(upgrade, newcomer);
}

}  // namespace telepalp::gateway
