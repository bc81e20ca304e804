#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace telepalp::wire {

/// How the images come: the line in a client's log, and the text of the station's event in a session.
[[nodiscard]] std::string images_come_over_tcp();
/// `way`: that of the datagrams and its price, such as "over a relay (UDP), round trip 43 ms"; empty: to the server's
/// own UDP port.
[[nodiscard]] std::string images_come_by_datagram(std::string_view way);

/// The way that such a text names, as the end of the sentence "the images went …". nullopt: it is another text.
[[nodiscard]] std::optional<std::string> way_of_images(std::string_view text);

}  // namespace telepalp::wire
