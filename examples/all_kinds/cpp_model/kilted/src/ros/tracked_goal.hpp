// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__TRACKED_GOAL_HPP_
#define ROS__TRACKED_GOAL_HPP_

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

#include "all_kinds/ros/action_client.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// What is known of a goal that the node has sent; thread-safe.
template<typename Action, typename Handle>
class TrackedGoal
{
public:
  using Clock = std::chrono::steady_clock;
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
    feedback_.swap(feedback);
  }

  /// Store the handle of the accepted goal; return whether it was canceled in the meantime.
  bool accept(const Handle & handle)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_running()) {
      state_ = ActionState::active;
      handle_ = handle;
    }
    return wants_cancel_;
  }

  /// Mark the goal as to be canceled; return its handle if the server has accepted it.
  Handle want_cancel()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wants_cancel_ = is_running();
    return handle_;
  }

  void set_cancel_answered()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_cancel_answered_ = true;
    }
    changed_.notify_all();
  }

  /// Wait until the server has answered the cancel, or the goal has ended.
  void wait_until_canceled(Clock::time_point end)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_until(lock, end, [this] {return is_cancel_answered_ || !is_running();});
  }

  /// End the goal, unless it has ended before.
  void end(ActionState state, Result result = nullptr)
  {
    Handle handle;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (state_ != ActionState::idle && !is_running()) {
        return;
      }
      state_ = state;
      result_ = std::move(result);
      handle_.swap(handle);
    }
    changed_.notify_all();
  }

  /// End the goal as lost when its server has been away for too long.
  void watch(bool is_server_ready)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (is_server_ready || !is_running()) {
        is_server_away_ = false;
        return;
      }
      if (!is_server_away_) {
        is_server_away_ = true;
        away_since_ = Clock::now();
      }
      if (Clock::now() - away_since_ < timeouts::LOST) {
        return;
      }
    }
    end(ActionState::lost);
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
  bool is_running() const
  {
    return state_ == ActionState::pending || state_ == ActionState::active;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  ActionState state_ = ActionState::idle;
  Feedback feedback_;
  Result result_;
  Handle handle_;
  bool wants_cancel_ = false;
  bool is_cancel_answered_ = false;
  bool is_server_away_ = false;
  Clock::time_point away_since_;
};

}  // namespace all_kinds

#endif  // ROS__TRACKED_GOAL_HPP_
