#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "proto/wire/message.h"

namespace telepalp::report {

/// `messages` with `change` applied to each message of type `Proto` on `topic`.
template <class Proto, class Change>
void change_each(std::vector<wire::Message>& messages, const wire::Topic& topic, Change change) {
  for (wire::Message& message : messages) {
    if (message.topic.name != topic.name) continue;
    Proto proto;
    ASSERT_TRUE(proto.ParseFromString(*message.payload));
    change(proto);
    message = wire::make_message(topic, message.published, proto, message.key_frame);
  }
}

}  // namespace telepalp::report
