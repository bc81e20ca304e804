// What a browser or a stranger sends to the web port: a request with its headers, token and cookie, as the upgrade to a
// WebSocket has them, and the texts and data of the Foxglove protocol after it. The first byte chooses the kind.
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "proto/keys/audit_anchor.h"
#include "proto/keys/token.h"
#include "proto/keys/x509/openssl.h"
#include "proto/words/demand.h"
#include "server/gateway/foxglove_protocol.h"
#include "server/gateway/request/request_headers.h"
#include "server/gateway/request_policy.h"
#include "server/gateway/sign_in.h"
#include "server/gateway/sign_in/fragment_count.h"

namespace {

using namespace telepalp;
namespace beast = boost::beast;
namespace http = beast::http;

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

bool is_within(std::string_view part, std::string_view whole) {
  return part.empty() || (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

/// No token is valid, because the fuzzer does not have the authority's key.
void sign_in(std::string_view token) {
  static const keys::PrivateKeyPtr authority = keys::new_private_key();
  demand(!keys::read_token(token, *authority, keys::WallTime{}).ok(), "nobody guesses a token");
}

void request(std::string_view bytes) {
  http::request_parser<http::string_body> parser;
  parser.header_limit(8192);
  parser.body_limit(4096);
  parser.eager(true);
  beast::error_code failed;
  parser.put(boost::asio::buffer(bytes.data(), bytes.size()), failed);
  if (failed || !parser.is_header_done()) return;
  const auto& asked = parser.get();
  const gateway::RequestPolicy policy{.allowed_hosts = {"patient.example"},
                                      .allowed_origins = {"https://studio.example"}};
  const std::string_view origin = view(asked[http::field::origin]);
  const std::string_view host = view(asked[http::field::host]);
  if (gateway::origin_is_allowed(policy, origin, host, false))
    demand(origin == "https://studio.example" || gateway::host_is_ours(policy, host), "a foreign page stays outside");
  const std::string_view target = view(asked.target());
  const std::string_view token = gateway::token_in_target(target);
  demand(is_within(token, target) && token.find('&') == std::string_view::npos, "a token is a part of the target");
  sign_in(token);
  sign_in(gateway::bearer_token(view(asked[http::field::authorization])));
  sign_in(gateway::token_in_form(asked.body()));
  const std::string_view cookies = view(asked[http::field::cookie]);
  demand(is_within(gateway::our_cookie(cookies), cookies), "a cookie is a part of its header");
  (void)gateway::takes_coding(view(asked[http::field::accept_encoding]), "br");
  (void)gateway::names_etag(view(asked[http::field::if_none_match]), "\"etag\"");
  (void)gateway::check_origin(origin);
  if (beast::websocket::is_upgrade(asked))
    (void)gateway::foxglove::choose_subprotocol(view(asked[http::field::sec_websocket_protocol]));
}

/// Reads `bytes` as WebSocket frames of a stranger, and as a line and an anchor of an audit log from a damaged disk.
void lines(std::string_view bytes) {
  gateway::FragmentCount at_once, one_by_one;
  const auto* frames = reinterpret_cast<const std::uint8_t*>(bytes.data());
  bool taken = true;
  for (std::size_t at = 0; at < bytes.size() && taken; ++at) taken = one_by_one.take(frames + at, 1);
  demand(at_once.take(frames, bytes.size()) == taken, "fragments are counted however the bytes arrive");
  keys::AuditVerifier verifier;
  (void)verifier.add(bytes);
  demand(!keys::read_anchor(bytes, "").ok(), "nobody signs an anchor without a key");
}

void data(std::string_view bytes) {
  const auto read = gateway::foxglove::read_client_data(bytes);
  if (read) demand(read->payload.size() + 5 == bytes.size(), "the payload follows the header of 5 bytes");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(bytes + 1), size - 1);
  if (bytes[0] == 0) request(rest);
  if (bytes[0] == 1) (void)gateway::foxglove::read_request(std::string(rest));
  if (bytes[0] == 2) data(rest);
  if (bytes[0] == 3) lines(rest);
  return 0;
}
