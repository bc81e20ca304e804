#include "server/meet/caller/client_hello.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/server/meet/greeting.h"

namespace telepalp::meet {
namespace {

using State = HelloRead::State;

HelloRead read(const std::string& bytes) { return read_client_hello(std::as_bytes(std::span(bytes))); }

/// The same message in records of `size` bytes.
std::string in_records_of(std::size_t size, const std::string& greeting) {
  const std::string message = greeting.substr(5);
  std::string records;
  for (std::size_t at = 0; at < message.size(); at += size) {
    const std::string part = message.substr(at, size);
    records += greeting.substr(0, 3);
    records += static_cast<char>(part.size() >> 8U);
    records += static_cast<char>(part.size() & 0xffU);
    records += part;
  }
  return records;
}

TEST(ClientHello, TellsTheNameAndWhetherTheCallerIsABrowser) {
  const HelloRead program = read(greeting("Ward3.Example"));
  ASSERT_EQ(program.state, State::Whole);
  EXPECT_EQ(program.hello.server_name, "ward3.example");
  EXPECT_FALSE(program.hello.speaks_http);
  EXPECT_TRUE(read(greeting("ward3", "\x02h2\x08http/1.1")).hello.speaks_http);
  EXPECT_EQ(read(greeting("")).hello.server_name, "");
  EXPECT_EQ(read(greeting("")).state, State::Whole);
}

TEST(ClientHello, IsIncompleteUntilItsLastByteAndReadsItInAnyRecords) {
  const std::string whole = greeting("ward3", "\x08http/1.1");
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes)
    ASSERT_EQ(read(whole.substr(0, bytes)).state, State::Incomplete) << bytes;
  for (const std::size_t size : {1, 3, 100}) {
    const HelloRead cut = read(in_records_of(size, whole));
    ASSERT_EQ(cut.state, State::Whole) << size;
    EXPECT_EQ(cut.hello.server_name, "ward3");
    EXPECT_TRUE(cut.hello.speaks_http);
  }
}

TEST(ClientHello, IsNotTlsForOtherBytesAndLengthsThatLie) {
  EXPECT_EQ(read("GET / HTTP/1.1\r\n").state, State::NotTls);
  EXPECT_EQ(read("TPMEET1\n").state, State::NotTls);
  EXPECT_EQ(read(std::string("\x16\x03\x01\x00\x00", 5)).state, State::NotTls) << "an empty record";
  EXPECT_EQ(read(std::string("\x16\x03\x01\xff\xff", 5)).state, State::NotTls) << "a record that is too long";
  EXPECT_EQ(read(std::string("\x16\x03\x01\x00\x04\x02\x00\x00\x00", 9)).state, State::NotTls) << "a ServerHello";
  EXPECT_EQ(read(std::string("\x16\x03\x01\x00\x04\x01\xff\xff\xff", 9)).state, State::NotTls) << "16 MB are announced";
  std::string damaged = greeting("ward3");
  damaged[5 + 4 + 34] = '\xff';  // the length of the session's number
  EXPECT_EQ(read(damaged).state, State::NotTls);
}

TEST(ClientHello, OfAnyDamageReadsNoByteBeyondTheEnd) {
  const std::string whole = greeting("ward3", "\x08http/1.1");
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char value : {'\x00', '\x01', '\x7f', '\xff'}) {
      std::string damaged = whole;
      damaged[at] = value;
      const std::unique_ptr<std::byte[]> exact(new std::byte[damaged.size()]);  // a sanitizer sees one byte too many
      std::copy_n(reinterpret_cast<const std::byte*>(damaged.data()), damaged.size(), exact.get());
      const HelloRead found = read_client_hello({exact.get(), damaged.size()});
      EXPECT_LE(found.hello.server_name.size(), 255U);
    }
}

TEST(ClientHello, OfManyProtocolsIsStillFound) {
  const HelloRead many = read(greeting("ward3", "\x08http/1.1", 1000));
  ASSERT_EQ(many.state, State::Whole);
  EXPECT_TRUE(many.hello.speaks_http);
}

}  // namespace
}  // namespace telepalp::meet
