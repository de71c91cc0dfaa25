// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS_PUBLISHER_HPP_
#define ROS_PUBLISHER_HPP_

#include <memory>

#include "rclcpp_lifecycle/lifecycle_publisher.hpp"

#include "contact_analysis/publisher.hpp"

namespace contact_analysis
{

/// Publishes messages while the node is active.
template<typename Message>
class RosPublisher : public Publisher<Message>
{
public:
  using Pointer = std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Message>>;

  explicit RosPublisher(const Pointer & publisher)
  : publisher_(publisher)
  {
  }

  void publish(const Message & message) override {publisher_->publish(message);}

private:
  Pointer publisher_;
};

}  // namespace contact_analysis

#endif  // ROS_PUBLISHER_HPP_
