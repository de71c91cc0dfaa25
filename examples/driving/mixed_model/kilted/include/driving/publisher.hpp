// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef DRIVING__PUBLISHER_HPP_
#define DRIVING__PUBLISHER_HPP_

namespace driving
{

/// Publishes messages to a topic. This base class, for tests without ROS, drops them.
template<typename Message>
class Publisher
{
public:
  virtual ~Publisher() = default;

  /// Publish a message.
  virtual void publish(const Message & /* message */) {}
};

}  // namespace driving

#endif  // DRIVING__PUBLISHER_HPP_
