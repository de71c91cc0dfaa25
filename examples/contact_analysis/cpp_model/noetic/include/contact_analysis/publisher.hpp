// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__PUBLISHER_HPP_
#define CONTACT_ANALYSIS__PUBLISHER_HPP_

namespace contact_analysis
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

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__PUBLISHER_HPP_
