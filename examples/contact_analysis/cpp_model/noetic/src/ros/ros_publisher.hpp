// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS__ROS_PUBLISHER_HPP_
#define ROS__ROS_PUBLISHER_HPP_

#include "ros/publisher.h"

#include "contact_analysis/publisher.hpp"

namespace contact_analysis
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

private:
  ros::Publisher publisher_;
};

}  // namespace contact_analysis

#endif  // ROS__ROS_PUBLISHER_HPP_
