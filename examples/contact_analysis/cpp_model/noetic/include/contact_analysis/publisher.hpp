// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__PUBLISHER_HPP_
#define CONTACT_ANALYSIS__PUBLISHER_HPP_

namespace contact_analysis
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

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__PUBLISHER_HPP_
