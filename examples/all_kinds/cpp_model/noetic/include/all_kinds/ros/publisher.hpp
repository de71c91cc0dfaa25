// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__PUBLISHER_HPP_
#define ALL_KINDS__ROS__PUBLISHER_HPP_

#include <cstddef>

namespace all_kinds
{

/// Publishes messages to a topic. This base class, for tests without ROS, drops them.
template<typename Message>
class Publisher
{
public:
  virtual ~Publisher() = default;

  /// Publish a message.
  virtual void publish(const Message & /* message */) {}

  /// Return how many subscribe to the topic.
  virtual std::size_t subscriber_count() {return 0;}
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__PUBLISHER_HPP_
