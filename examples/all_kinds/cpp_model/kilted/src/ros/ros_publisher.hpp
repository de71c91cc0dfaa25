// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_PUBLISHER_HPP_
#define ROS__ROS_PUBLISHER_HPP_

#include <memory>
#include <utility>

#include "rclcpp/publisher.hpp"

#include "all_kinds/ros/publisher.hpp"

namespace all_kinds
{

/// Publishes messages of the logic to a topic.
template<typename Message>
class RosPublisher : public Publisher<Message>
{
public:
  explicit RosPublisher(std::shared_ptr<rclcpp::Publisher<Message>> publisher)
  : publisher_(std::move(publisher))
  {
  }

  void publish(const Message & message) override {publisher_->publish(message);}

private:
  std::shared_ptr<rclcpp::Publisher<Message>> publisher_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_PUBLISHER_HPP_
