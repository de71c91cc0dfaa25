// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__PUBLISHER_HPP_
#define ALL_KINDS__PUBLISHER_HPP_

namespace all_kinds
{

/// Sends messages to a topic. This one, for tests without ROS, sends them nowhere.
template<typename Message>
class Publisher
{
public:
  virtual ~Publisher() = default;

  /// Send a message at once.
  virtual void publish(const Message & /* message */) {}
};

}  // namespace all_kinds

#endif  // ALL_KINDS__PUBLISHER_HPP_
