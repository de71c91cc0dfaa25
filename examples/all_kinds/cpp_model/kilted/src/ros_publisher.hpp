// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_PUBLISHER_HPP_
#define ROS_PUBLISHER_HPP_

#include <memory>

#include "rclcpp_lifecycle/lifecycle_publisher.hpp"

#include "all_kinds/publisher.hpp"

namespace all_kinds
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

}  // namespace all_kinds

#endif  // ROS_PUBLISHER_HPP_
