#pragma once

#include <gtest/gtest.h>

#include <string>

#include "proto/keys/tls_context.h"

namespace telepalp::keys {

/// Client and server with these settings shake hands without a network. True if both ends accept: the client expects
/// `host`, and the server gets the client's certificate.
inline bool shake_hands(SSL_CTX& servers, SSL_CTX& clients, const std::string& host) {
  SSL* const server = SSL_new(&servers);
  SSL* const client = SSL_new(&clients);
  BIO* to_server = nullptr;
  BIO* to_client = nullptr;
  EXPECT_EQ(BIO_new_bio_pair(&to_client, 0, &to_server, 0), 1);
  SSL_set_bio(server, to_client, to_client);
  SSL_set_bio(client, to_server, to_server);
  SSL_set_accept_state(server);
  SSL_set_connect_state(client);
  expect_host(*client, host);
  for (int round = 0; round < 10; ++round) {
    (void)SSL_do_handshake(client);
    (void)SSL_do_handshake(server);
  }
  const bool accepted = SSL_is_init_finished(client) == 1 && SSL_is_init_finished(server) == 1;
  SSL_free(client);
  SSL_free(server);
  return accepted;
}

inline bool shake_hands(const KeyFile& server, const KeyFile& client, const std::string& host) {
  const Result<TlsContextPtr> servers = server_context(server, [](const Identity&) { return false; });
  const Result<TlsContextPtr> clients = client_context(client);
  EXPECT_TRUE(servers.ok() && clients.ok());
  return servers && clients && shake_hands(**servers, **clients, host);
}

}  // namespace telepalp::keys
