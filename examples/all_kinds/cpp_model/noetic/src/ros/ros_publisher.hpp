// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_PUBLISHER_HPP_
#define ROS__ROS_PUBLISHER_HPP_

#include <cstddef>

#include "ros/publisher.h"

#include "all_kinds/ros/publisher.hpp"

namespace all_kinds
{

/// Publishes messages to a topic.
template<typename Message>
class RosPublisher : public Publisher<Message>
{
public:
  explicit RosPublisher(const ros::Publisher & publisher)
  : publisher_(publisher)
  {
  }

  void publish(const Message & message) override {publisher_.publish(message);}

  std::size_t subscriber_count() override {return publisher_.getNumSubscribers();}

private:
  ros::Publisher publisher_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_PUBLISHER_HPP_
