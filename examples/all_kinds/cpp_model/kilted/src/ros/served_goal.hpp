// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SERVED_GOAL_HPP_
#define ROS__SERVED_GOAL_HPP_

#include <atomic>
#include <exception>
#include <memory>

#include "rclcpp_action/rclcpp_action.hpp"

#include "all_kinds/ros/goal.hpp"

namespace all_kinds
{

/// A goal received from a client, which always gets a result.
template<typename Action>
class ServedGoal : public Goal<Action>
{
public:
  using Handle = rclcpp_action::ServerGoalHandle<Action>;

  explicit ServedGoal(const std::shared_ptr<Handle> & handle)
  : Goal<Action>(*handle->get_goal()),
    handle_(handle)
  {
  }

  bool cancel_requested() override {return is_unwanted_ || handle_->is_canceling();}

  void publish_feedback() override
  {
    try {
      handle_->publish_feedback(std::make_shared<typename Action::Feedback>(this->feedback));
    } catch (const std::exception &) {
      // The context is shut down.
    }
  }

  /// Ask the logic to end the goal: the node stops, or a new goal replaces this one.
  void ask_to_end() {is_unwanted_ = true;}

  /// Send the outcome to the client.
  void finish()
  {
    end(this->outcome(), std::make_shared<typename Action::Result>(this->result));
  }

  /// Abort the goal for a logic that does not return.
  void give_up() {end(Outcome::aborted, std::make_shared<typename Action::Result>());}

private:
  void end(Outcome outcome, const std::shared_ptr<typename Action::Result> & result)
  {
    if (has_ended_.exchange(true)) {
      return;
    }
    try {
      if (outcome == Outcome::succeeded) {
        handle_->succeed(result);
      } else if (outcome == Outcome::canceled && handle_->is_canceling()) {
        handle_->canceled(result);
      } else {
        handle_->abort(result);
      }
    } catch (const std::exception &) {
      // The context is shut down.
    }
  }

  std::shared_ptr<Handle> handle_;
  std::atomic<bool> is_unwanted_{false};
  std::atomic<bool> has_ended_{false};
};

}  // namespace all_kinds

#endif  // ROS__SERVED_GOAL_HPP_
