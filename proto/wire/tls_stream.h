#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>
#include <string>

#include "proto/keys/key_file.h"
#include "proto/keys/tls_context.h"
#include "proto/wire/byte_stream.h"

namespace telepalp::wire {

/// The TLS settings of one end, shared by its connections.
using TlsSettings = std::shared_ptr<boost::asio::ssl::context>;

[[nodiscard]] Result<TlsSettings> tls_settings(Result<keys::TlsContextPtr> context);

/// A stream over TLS 1.3, at a server. The handshake begins with the first read or write. A peer whose first byte is
/// not one of TLS is served in plain text: is_sealed() tells, and the server then says goodbye and why.
[[nodiscard]] std::unique_ptr<ByteStream> tls_at_server(boost::asio::ip::tcp::socket socket, TlsSettings settings);

/// The same at a client of the server `host`. `key`: for what refusal() says.
[[nodiscard]] std::unique_ptr<ByteStream> tls_at_client(boost::asio::ip::tcp::socket socket, TlsSettings settings,
                                                        std::string host, std::shared_ptr<const keys::KeyFile> key);

}  // namespace telepalp::wire
