// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_PUBLISHER_HPP_
#define ROS__ROS_PUBLISHER_HPP_

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "rclcpp/publisher.hpp"

#include "all_kinds/ros/publisher.hpp"

namespace all_kinds
{

/// Publishes messages to a topic, in memory of the middleware where it lends some.
template<typename Message>
class RosPublisher : public Publisher<Message>
{
public:
  using Pointer = std::shared_ptr<rclcpp::Publisher<Message>>;

  /// Within a process, rclcpp hands messages on by unique pointer: no loan then.
  RosPublisher(const Pointer & publisher, bool is_intra_process)
  : publisher_(publisher),
    lends_(!is_intra_process && publisher->can_loan_messages())
  {
  }

  void publish(const Message & message) override
  {
    if (lends_) {
      auto loan = publisher_->borrow_loaned_message();
      loan.get() = message;
      publisher_->publish(std::move(loan));
    } else {
      publisher_->publish(message);
    }
  }

private:
  Pointer publisher_;
  bool lends_;
};

/// Wait until all subscribers have received what these publishers have sent, within a time.
inline void wait_until_received(
  const std::vector<rclcpp::PublisherBase::SharedPtr> & publishers,
  std::chrono::steady_clock::time_point end)
{
  for (const auto & publisher : publishers) {
    const auto rest = std::max(end - std::chrono::steady_clock::now(), std::chrono::nanoseconds(0));
    try {
      publisher->wait_for_all_acked(rest);
    } catch (const std::exception &) {
      return;  // The middleware cannot tell.
    }
  }
}

}  // namespace all_kinds

#endif  // ROS__ROS_PUBLISHER_HPP_
