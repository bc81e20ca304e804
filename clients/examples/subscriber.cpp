// A subscriber in C++: prints the depth at the centre of each image of a server on this machine, for ten seconds.

#include <boost/asio/io_context.hpp>
#include <cstdio>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/wire/client/client_link.h"

int main() {
  using namespace telepalp;
  boost::asio::io_context io;
  codec::DepthReader reader;
  wire::ClientLink* link = nullptr;
  const auto on_message = [&](const wire::Message& message) {
    msg::DepthImage image;
    if (!image.ParseFromString(*message.payload)) return;
    const auto depth = reader.read(std::as_bytes(std::span(image.data())));
    if (!depth) return link->request_key_frame(message);  // it joined in the middle of a group of pictures
    const auto at = static_cast<std::size_t>(depth->image.width) * static_cast<std::size_t>(depth->image.height / 2) +
                    static_cast<std::size_t>(depth->image.width / 2);
    std::printf("image %llu: depth of its middle pixel %.3f m\n", static_cast<unsigned long long>(image.sequence()),
                depth->image.unit_m * depth->image.samples[at]);
  };
  wire::ClientLink camera(io, {.port = 7400, .name = "example", .subscribes = {"/camera/depth"}},
                          {.on_message = on_message});
  link = &camera;
  camera.start();
  io.run_for(std::chrono::seconds(10));
}
