// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_PUBLISHER_HPP_
#define ROS__ROS_PUBLISHER_HPP_

#include <cstddef>
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

  std::size_t subscriber_count() override {return publisher_->get_subscription_count();}

private:
  std::shared_ptr<rclcpp::Publisher<Message>> publisher_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_PUBLISHER_HPP_
