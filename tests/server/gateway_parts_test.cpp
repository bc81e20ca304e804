#include <gtest/gtest.h>

#include <zlib.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "server/gateway/foxglove/playback_control.h"
#include "server/gateway/foxglove_protocol.h"
#include "server/gateway/http_reply.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/sign_in/fragment_count.h"
#include "server/gateway/static_files.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;
namespace http = boost::beast::http;
namespace fg = gateway::foxglove;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("gateway_parts_" + std::to_string(::getpid()))) {
    fs::create_directories(path_ / "viewer");
    write("viewer/index.html", "<p>hello</p>");
    write("viewer/viewer.js", "1");
    write("viewer/page.css", std::string(100'000, 'p'));
    write("viewer/.secret.js", "2");
    write("viewer/notes.exe", "3");
    write("outside.txt", "4");
    fs::create_symlink(path_ / "outside.txt", path_ / "viewer/link.txt");
  }
  ~Folder() { fs::remove_all(path_); }
  fs::path viewer() const { return path_ / "viewer"; }
  fs::path root() const { return path_; }

 private:
  void write(const std::string& name, const std::string& text) { std::ofstream(path_ / name) << text; }
  fs::path path_;
};

gateway::HttpRequest get(std::string_view target, std::string_view host = "127.0.0.1:8080") {
  gateway::HttpRequest request{http::verb::get, boost::beast::string_view(target.data(), target.size()), 11};
  request.set(http::field::host, boost::beast::string_view(host.data(), host.size()));
  return request;
}

TEST(StaticFiles, OnlyAViewersOwnFilesAreServed) {
  const Folder folder;
  const auto files = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(files);
  EXPECT_EQ(files->find("/")->bytes, "<p>hello</p>");
  EXPECT_EQ(files->find("/viewer.js?v=2")->content_type, "text/javascript; charset=utf-8");
  for (const char* target : {"/link.txt", "/.secret.js", "/notes.exe", "/../outside.txt", "/..%2foutside.txt",
                             "//etc/passwd", "", "*", "viewer.js", "http://127.0.0.1/viewer.js", "/viewer.js/"})
    EXPECT_EQ(files->find(target), nullptr) << target;
  EXPECT_EQ(files->find(std::string_view("/viewer.js\0.txt", 15)), nullptr);
}

TEST(StaticFiles, AFolderWithoutAViewerIsRefusedWithItsName) {
  const Folder folder;
  const auto none = gateway::StaticFiles::read(folder.root());
  ASSERT_FALSE(none);
  EXPECT_NE(to_string(none.error()).find(folder.root().string()), std::string::npos);
  EXPECT_FALSE(gateway::StaticFiles::read(folder.root() / "absent"));
}

TEST(HttpReply, FilesComeWithTheirTypeAndNothingFromElsewhereMayRun) {
  const Folder folder;
  const auto files = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(files);
  const gateway::HttpReply reply = gateway::reply_to(get("/viewer.js"), *files, {}, {});
  EXPECT_EQ(reply.result_int(), 200u);
  EXPECT_EQ(reply[http::field::cache_control], "no-cache");
  EXPECT_EQ(reply["X-Content-Type-Options"], "nosniff");
  const std::string policy(reply["Content-Security-Policy"]);
  EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(policy.find("'unsafe-eval'"), std::string::npos);
  EXPECT_EQ(policy.find("'unsafe-inline'"), std::string::npos);
  gateway::HttpRequest again = get("/viewer.js");
  again.set(http::field::if_none_match, reply[http::field::etag]);
  EXPECT_EQ(gateway::reply_to(again, *files, {}, {}).result_int(), 304u);
}

/// The decompressed body, as in a browser.
std::string unzipped(const std::string& bytes) {
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  std::string out(1 << 20, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return out;
}

gateway::HttpReply page_for(const gateway::StaticFiles& files, const char* accept_encoding,
                            boost::beast::string_view known = "") {
  gateway::HttpRequest request = get("/page.css");
  if (accept_encoding != nullptr) request.set(http::field::accept_encoding, accept_encoding);
  if (!known.empty()) request.set(http::field::if_none_match, known);
  return gateway::reply_to(request, files, {}, {});
}

TEST(HttpReply, AFileIsCompressedForABrowserThatTakesGzipAndForNoOther) {
  const Folder folder;
  const auto files = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(files);
  const gateway::HttpReply small = page_for(*files, "br, GZIP;q=0.8, deflate");
  EXPECT_EQ(small[http::field::content_encoding], "gzip");
  EXPECT_LT(small.body().size(), 1000u);
  EXPECT_EQ(unzipped(small.body()), std::string(100'000, 'p'));
  for (const char* accepted : {"*", "*;q=0.1, br", "gzip"})
    EXPECT_EQ(page_for(*files, accepted)[http::field::content_encoding], "gzip") << accepted;
  for (const char* refused :
       {static_cast<const char*>(nullptr), "", "br", "gzip;q=0", "gzip; q=0.000", "*;q=0", "gzip;q=0, *", "xgzip"}) {
    const gateway::HttpReply plain = page_for(*files, refused);
    EXPECT_EQ(plain.count(http::field::content_encoding), 0u) << (refused ? refused : "no header");
    EXPECT_EQ(plain.body().size(), 100'000u);
    EXPECT_EQ(plain[http::field::vary], "Accept-Encoding") << "a cache between must keep the two forms apart";
  }
}

TEST(HttpReply, ABrotliFormThatTheBuildMadeIsServedInsteadOfGzipAndAnOldOneIsNot) {
  const Folder folder;
  const std::filesystem::path compressed = folder.viewer() / "page.css.br";
  std::ofstream(compressed) << "brotli";
  const auto made = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(made);
  const gateway::HttpReply small = page_for(*made, "gzip, deflate, br");
  EXPECT_EQ(small[http::field::content_encoding], "br");
  EXPECT_EQ(small.body(), "brotli");
  EXPECT_NE(small[http::field::etag], page_for(*made, "gzip")[http::field::etag]);
  EXPECT_EQ(page_for(*made, "gzip, br;q=0")[http::field::content_encoding], "gzip");
  EXPECT_EQ(made->find("/page.css.br"), nullptr) << "it is a form, and no file of its own";

  std::filesystem::last_write_time(compressed, std::filesystem::file_time_type::min());
  const auto old = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(old);
  EXPECT_EQ(page_for(*old, "gzip, br")[http::field::content_encoding], "gzip") << "it is of another build";
}

TEST(HttpReply, TheTwoFormsOfAFileHaveTagsOfTheirOwnAndAListOfTagsIsRead) {
  const Folder folder;
  const auto files = gateway::StaticFiles::read(folder.viewer());
  ASSERT_TRUE(files);
  const std::string small(page_for(*files, "gzip")[http::field::etag]);
  const std::string plain(page_for(*files, nullptr)[http::field::etag]);
  EXPECT_NE(small, plain);
  const std::string both = "\"other\" , W/" + small;
  EXPECT_EQ(page_for(*files, "gzip", small).result_int(), 304u);
  EXPECT_EQ(page_for(*files, "gzip", both).result_int(), 304u);
  EXPECT_EQ(page_for(*files, "gzip", "*").result_int(), 304u);
  EXPECT_EQ(page_for(*files, "gzip", plain).result_int(), 200u);
  EXPECT_EQ(page_for(*files, nullptr, small).result_int(), 200u);
  EXPECT_TRUE(page_for(*files, "gzip", small).body().empty());
}

TEST(HttpReply, OtherMethodsAndOtherNamesAreRefused) {
  gateway::HttpRequest post = get("/");
  post.method(http::verb::post);
  EXPECT_EQ(gateway::reply_to(post, {}, {}, {}).result_int(), 405u);
  EXPECT_EQ(gateway::reply_to(get("/"), {}, {}, {}).result_int(), 404u);
  EXPECT_EQ(gateway::reply_to(get("/", "evil.example:8080"), {}, {}, {}).result_int(), 421u);
  EXPECT_EQ(gateway::reply_to(get("/", ""), {}, {}, {}).result_int(), 421u);
}

TEST(HttpReply, GivesTheSessionClock) {
  const gateway::HttpReply reply =
      gateway::reply_to(get("/session_clock"), {}, {}, session_time(1'700'000'000'123'456'789));
  EXPECT_EQ(reply.body(), "1700000000123456789");
  EXPECT_EQ(reply[http::field::cache_control], "no-store");
}

struct OriginCase {
  const char* behaviour;
  const char* origin;
  const char* host;
  bool trusted_program;
  bool allowed;
};
const OriginCase kOrigins[] = {
    {"our own page", "http://127.0.0.1:8080", "127.0.0.1:8080", true, true},
    {"our own host by another scheme than ours", "https://10.0.0.5", "10.0.0.5", false, false},
    {"our own host by no scheme of the web", "x://127.0.0.1:8080", "127.0.0.1:8080", true, false},
    {"our own page by name", "http://localhost:8080", "localhost:8080", true, true},
    {"our own page, IPv6", "http://[::1]:8080", "[::1]:8080", true, true},
    {"a foreign page", "http://evil.example", "127.0.0.1:8080", true, false},
    {"another port of this machine", "http://127.0.0.1:3000", "127.0.0.1:8080", true, false},
    {"a page whose own name was made to resolve to us", "http://evil.example:8080", "evil.example:8080", true, false},
    {"a file or a sandboxed frame", "null", "127.0.0.1:8080", true, false},
    {"an origin that is no origin", "127.0.0.1:8080", "127.0.0.1:8080", true, false},
    {"a program on this machine, or with a token", "", "127.0.0.1:8080", true, true},
    {"a program elsewhere without a token", "", "10.0.0.5:8080", false, false},
    {"a page that is allowed by name", "https://viewer.example", "10.0.0.5:8080", false, true},
};

TEST(RequestPolicy, AnAllowedOriginIsExact) {
  for (const char* good :
       {"https://app.foxglove.dev", "http://localhost:8080", "http://[::1]:8080", "app://lichtblick"})
    EXPECT_TRUE(gateway::check_origin(good)) << good;
  for (const char* bad : {"*", "null", "", "https://", "https://*.example", "https://a.example/", "a.example",
                          "https://A.example", "https://a.example, https://b.example", "://a.example"})
    EXPECT_FALSE(gateway::check_origin(bad)) << bad;
}

TEST(RequestPolicy, OnlyOurOwnPagesAndTrustedProgramsMayOpenTheStream) {
  const gateway::RequestPolicy policy{.allowed_hosts = {}, .allowed_origins = {"https://viewer.example"}};
  for (const OriginCase& one : kOrigins)
    EXPECT_EQ(gateway::origin_is_allowed(policy, one.origin, one.host, one.trusted_program), one.allowed)
        << one.behaviour;
}

TEST(RequestPolicy, AServerWithKeysTakesItsPagesByHttpsAlone) {
  const gateway::RequestPolicy policy{.allowed_hosts = {}, .scheme = "https", .allowed_origins = {}};
  EXPECT_TRUE(gateway::origin_is_allowed(policy, "https://10.0.0.5:8765", "10.0.0.5:8765", false));
  EXPECT_FALSE(gateway::origin_is_allowed(policy, "http://10.0.0.5:8765", "10.0.0.5:8765", false));
}

TEST(RequestPolicy, AWildcardOfAWebCertificateStandsForOneLabel) {
  const gateway::RequestPolicy policy{.allowed_hosts = {"*.hospital.example"}, .allowed_origins = {}};
  EXPECT_TRUE(gateway::host_is_ours(policy, "tele.hospital.example:8765"));
  for (const char* other :
       {"hospital.example", "a.tele.hospital.example", ".hospital.example", "tele.hospital.example.evil",
        "telehospital.example", "*.hospital.example.evil", "example", ""})
    EXPECT_FALSE(gateway::host_is_ours(policy, other)) << other;
}

TEST(RequestPolicy, AHostNameMustBeAllowedByName) {
  const gateway::RequestPolicy policy{.allowed_hosts = {"theatre-3.hospital"}, .allowed_origins = {}};
  EXPECT_TRUE(gateway::host_is_ours(policy, "theatre-3.hospital:8080"));
  EXPECT_FALSE(gateway::host_is_ours(policy, "theatre-4.hospital:8080"));
  EXPECT_TRUE(gateway::host_is_ours(policy, "192.168.1.7"));
  EXPECT_FALSE(gateway::host_is_ours(policy, "[::1"));
  EXPECT_FALSE(gateway::host_is_ours(policy, "[]"));
}

/// A masked frame with `size` bytes of payload.
std::string frame(std::uint8_t first, std::size_t size) {
  std::string bytes(1, static_cast<char>(first));
  if (size < 126) {
    bytes += static_cast<char>(0x80U | size);
  } else {
    bytes += '\xfe';
    bytes += static_cast<char>(size >> 8U);
    bytes += static_cast<char>(size & 255U);
  }
  return bytes + std::string(4 + size, '\x01');
}

/// Whether FragmentCount takes `bytes`, `at_once` of them at a time.
bool takes(const std::string& bytes, std::size_t at_once) {
  gateway::FragmentCount count;
  for (std::size_t at = 0; at < bytes.size(); at += at_once)
    if (!count.take(reinterpret_cast<const std::uint8_t*>(bytes.data()) + at, std::min(at_once, bytes.size() - at)))
      return false;
  return true;
}

TEST(FragmentCount, CountsTheFragmentsOfOneMessageHoweverItsBytesArrive) {
  constexpr std::uint8_t kText = 0x01, kNext = 0x00, kLast = 0x80, kWhole = 0x81, kPing = 0x89;
  std::string whole, joined;
  for (int message = 0; message < 200; ++message) whole += frame(kWhole, message % 2 == 0 ? 20 : 300) + frame(kPing, 3);
  for (int message = 0; message < 200; ++message)
    joined += frame(kText, 2) + frame(kNext, 200) + frame(kPing, 0) + frame(kLast, 0);
  std::string endless = frame(kText, 0);
  for (int fragment = 0; fragment < 70; ++fragment) endless += frame(kNext, 0) + frame(kPing, 0);
  for (const std::size_t at_once : {1u, 7u, 100'000u}) {
    EXPECT_TRUE(takes(whole, at_once)) << at_once;
    EXPECT_TRUE(takes(joined, at_once)) << at_once;
    EXPECT_FALSE(takes(endless, at_once)) << at_once;
  }
}

TEST(FoxgloveProtocol, ASubprotocolThatBothSpeakIsChosenInTheClientsOrder) {
  EXPECT_EQ(gateway::foxglove::choose_subprotocol("foxglove.websocket.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(gateway::foxglove::choose_subprotocol("x , foxglove.sdk.v1,foxglove.websocket.v1"), "foxglove.sdk.v1");
  EXPECT_FALSE(gateway::foxglove::choose_subprotocol(""));
  EXPECT_FALSE(gateway::foxglove::choose_subprotocol("mqtt, foxglove.websocket.v2"));
}

TEST(FoxgloveProtocol, AMessagesHeaderIsThirteenLittleEndianBytes) {
  const auto header = gateway::foxglove::message_header(0x04030201, session_time(0x0807060504030201));
  const std::array<std::uint8_t, 13> expected{1, 1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(header, expected);
}

TEST(FoxgloveProtocol, RequestsAreReadAndOtherOperationsAreNamedInTheRefusal) {
  const auto subscribe = gateway::foxglove::read_request(
      R"({"op":"subscribe","subscriptions":[{"id":7,"channelId":2,"later":[1]}],"unknown":{"x":1}})");
  ASSERT_TRUE(subscribe);
  ASSERT_EQ(subscribe->subscribe.size(), 1u);
  EXPECT_EQ(subscribe->subscribe[0].id, 7u);
  EXPECT_EQ(subscribe->subscribe[0].channel, 2u);
  const auto advertise = gateway::foxglove::read_request(
      R"({"op":"advertise","channels":[{"id":9,"topic":"/viewer/hand","encoding":"protobuf","schemaName":"x"}]})");
  ASSERT_TRUE(advertise);
  ASSERT_EQ(advertise->advertise.size(), 1u);
  EXPECT_EQ(advertise->advertise[0].topic, "/viewer/hand");
  const auto other = gateway::foxglove::read_request(R"({"op":"setParameters","parameters":[]})");
  ASSERT_FALSE(other);
  EXPECT_NE(to_string(other.error()).find("'setParameters'"), std::string::npos);
}

/// Layout: opcode 03 | command | f32 speed | seek, 0 or 1 | u64 time [ns] | u32 length of id | id
std::string playback_request(char command, float speed, std::optional<std::uint64_t> seek_ns, const std::string& id) {
  std::string bytes{'\x03', command};
  const auto append = [&](std::uint64_t value, int size) {
    for (int at = 0; at < size; ++at) bytes += static_cast<char>(value >> (8 * at));
  };
  append(std::bit_cast<std::uint32_t>(speed), 4);
  append(seek_ns ? 1 : 0, 1);
  append(seek_ns.value_or(0), 8);
  append(id.size(), 4);
  return bytes + id;
}

msg::PlaybackState played() {
  msg::PlaybackState state;
  state.set_begin_ns(1'700'000'000'500'000'000);
  state.set_duration_s(60.0);
  state.set_position_s(2.0);
  state.set_speed(1.0);
  return state;
}

TEST(FoxglovePlayback, ARequestIsReadAndAnsweredWithTheStateItLeadsTo) {
  const msg::PlaybackState state = played();
  const std::string bytes = playback_request(0, 0.5F, 1'700'000'012'500'000'000, "seek-1");
  ASSERT_TRUE(fg::is_playback_request(bytes));
  const auto request = fg::read_playback_request(bytes, state);
  ASSERT_TRUE(request) << to_string(request.error());
  const msg::PlaybackCommand command = fg::command_of(*request, state);
  EXPECT_TRUE(command.play());
  EXPECT_EQ(command.speed(), 0.5);
  EXPECT_NEAR(command.seek_s(), 12.0, 1e-6);
  EXPECT_FALSE(command.has_loop() || command.has_step());
  const std::string reply = fg::playback_reply(state, *request);
  EXPECT_EQ(reply.substr(0, 2), std::string("\x05\x00", 2));
  EXPECT_EQ(reply.substr(2, 8), bytes.substr(7, 8)) << "the time that was asked for";
  EXPECT_EQ(reply.substr(10, 4), bytes.substr(2, 4)) << "the speed";
  EXPECT_EQ(reply.substr(14), std::string("\x01\x06\x00\x00\x00seek-1", 11));
}

TEST(FoxglovePlayback, TheStateIsPausedPlayingOrEnded) {
  msg::PlaybackState state = played();
  EXPECT_EQ(fg::playback_state(state)[1], 1);
  state.set_playing(true);
  EXPECT_EQ(fg::playback_state(state)[1], 0);
  state.set_playing(false);
  state.set_position_s(60.0);
  EXPECT_EQ(fg::playback_state(state)[1], 3);
  EXPECT_EQ(fg::playback_state(state).size(), 19u);
}

TEST(FoxglovePlayback, WrongRequestsAreRefused) {
  const msg::PlaybackState state = played();
  const std::string good = playback_request(1, 1.0F, std::nullopt, "id");
  EXPECT_TRUE(fg::read_playback_request(good, state));
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(fg::read_playback_request(good.substr(0, length), state)) << length;
  EXPECT_FALSE(fg::read_playback_request(good + "x", state));
  EXPECT_FALSE(fg::read_playback_request(playback_request(2, 1.0F, std::nullopt, "id"), state));
  EXPECT_FALSE(fg::read_playback_request(playback_request(0, std::nanf(""), std::nullopt, "id"), state));
  EXPECT_FALSE(fg::read_playback_request(playback_request(0, 1.0F, 5, "id"), state)) << "before the session";
  EXPECT_FALSE(fg::read_playback_request(playback_request(0, 1.0F, 1'800'000'000'000'000'000, "id"), state));
  EXPECT_FALSE(fg::read_playback_request(playback_request(0, 1.0F, std::nullopt, std::string(1000, 'i')), state));
}

TEST(FoxglovePlayback, OnlyAClientThatMayMoveTheSessionIsOfferedTheControl) {
  EXPECT_EQ(fg::server_info("server", "1", 2, "local").find("playbackControl"), std::string::npos);
  const std::string info = fg::server_info("server", "1", 2, "local", played());
  EXPECT_NE(info.find("playbackControl"), std::string::npos);
  EXPECT_NE(info.find("\"dataStartTime\":{\"sec\":1700000000,\"nsec\":500000000}"), std::string::npos) << info;
  EXPECT_NE(info.find("\"dataEndTime\":{\"sec\":1700000060,\"nsec\":500000000}"), std::string::npos) << info;
}

TEST(FoxgloveProtocol, InvalidTextIsOnlyAnError) {
  const std::string deep(60'000, '[');
  std::string nested = R"({"op":)";
  for (int depth = 0; depth < 10'000; ++depth) nested += R"({"a":)";
  for (const std::string& text :
       {std::string(), std::string("null"), std::string("[]"), std::string("{"), std::string("\0\xff\xfe", 3), deep,
        nested, std::string(R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})"),
        std::string(R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})"),
        std::string(R"({"op":"subscribe","subscriptions":7})"), std::string(R"({"op":["subscribe"]})")})
    EXPECT_FALSE(gateway::foxglove::read_request(text)) << text.substr(0, 60);
}

}  // namespace
}  // namespace telepalp::server
