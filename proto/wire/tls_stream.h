#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>
#include <string>

#include "proto/keys/key_file.h"
#include "proto/keys/tls_context.h"
#include "proto/wire/byte_stream.h"

namespace telepalp::wire {

/// The TLS settings (certificate, trusted authority) of one end, shared by its connections.
using TlsSettings = std::shared_ptr<boost::asio::ssl::context>;

[[nodiscard]] Result<TlsSettings> tls_settings(Result<keys::TlsContextPtr> context);

/// A stream over TLS 1.3, at a server. The handshake begins with the first read or write. A peer whose first byte does
/// not begin a TLS handshake gets plain text, so that the server can send it a Goodbye; is_sealed() is then false.
[[nodiscard]] std::unique_ptr<ByteStream> tls_at_server(boost::asio::ip::tcp::socket socket, TlsSettings settings);

/// A stream over TLS 1.3, at a client. The server's certificate must name `host`. `key`: for the text of refusal().
[[nodiscard]] std::unique_ptr<ByteStream> tls_at_client(boost::asio::ip::tcp::socket socket, TlsSettings settings,
                                                        std::string host, std::shared_ptr<const keys::KeyFile> key);

}  // namespace telepalp::wire
