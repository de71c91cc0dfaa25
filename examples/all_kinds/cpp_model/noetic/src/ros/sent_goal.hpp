// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SENT_GOAL_HPP_
#define ROS__SENT_GOAL_HPP_

#include <memory>
#include <mutex>
#include <utility>

#include "all_kinds/ros/action_client.hpp"

namespace all_kinds
{

/// The state of a sent goal; thread-safe.
template<typename Action>
class SentGoal
{
public:
  using Feedback = std::shared_ptr<const typename Action::Feedback>;
  using Result = std::shared_ptr<const typename Action::Result>;

  void set_state(ActionState state)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_ = state;
  }

  void set_feedback(Feedback feedback)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    feedback_ = std::move(feedback);
  }

  void finish(ActionState state, Result result)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_ = state;
    result_ = std::move(result);
  }

  ActionState state()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return state_;
  }

  Feedback feedback()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return feedback_;
  }

  Result result()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return result_;
  }

private:
  std::mutex mutex_;
  ActionState state_ = ActionState::idle;
  Feedback feedback_;
  Result result_;
};

}  // namespace all_kinds

#endif  // ROS__SENT_GOAL_HPP_
