// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ACTION_SERVER_HPP_
#define ACTION_SERVER_HPP_

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "rclcpp/context.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "all_kinds/goal.hpp"

namespace all_kinds
{

/// A goal received from a client.
template<typename Action>
class ServedGoal : public Goal<Action>
{
public:
  using Handle = rclcpp_action::ServerGoalHandle<Action>;

  ServedGoal(const std::shared_ptr<Handle> & handle, const rclcpp::Context::SharedPtr & context)
  : Goal<Action>(*handle->get_goal()),
    handle_(handle),
    context_(context)
  {
  }

  bool cancel_requested() override
  {
    return replaced_ || handle_->is_canceling() || !context_->is_valid();
  }

  void publish_feedback() override
  {
    if (context_->is_valid()) {
      handle_->publish_feedback(std::make_shared<typename Action::Feedback>(this->feedback));
    }
  }

  /// Preempt the goal in favour of a new one.
  void replace() {replaced_ = true;}

  /// Send the outcome to the client.
  void finish()
  {
    const auto result = std::make_shared<typename Action::Result>(this->result);
    if (this->outcome() == Outcome::succeeded) {
      handle_->succeed(result);
    } else if (this->outcome() == Outcome::canceled && handle_->is_canceling()) {
      handle_->canceled(result);
    } else {
      handle_->abort(result);
    }
  }

private:
  std::shared_ptr<Handle> handle_;
  rclcpp::Context::SharedPtr context_;
  std::atomic<bool> replaced_{false};
};

/// The queue of goals; the first is being executed.
template<typename Action>
class GoalQueue
{
public:
  using Pointer = std::shared_ptr<ServedGoal<Action>>;

  bool is_open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return open_;
  }

  void open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    open_ = true;
  }

  /// Reject new goals and preempt all others.
  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    open_ = false;
    replace_all();
    changed_.notify_one();
  }

  /// Queue a goal and preempt all before it.
  void push(const Pointer & goal)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    replace_all();
    goals_.push_back(goal);
    changed_.notify_one();
  }

  /// Return the next goal, or nullptr once the queue is closed and empty.
  Pointer front()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] {return !open_ || !goals_.empty();});
    return goals_.empty() ? nullptr : goals_.front();
  }

  void pop()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goals_.pop_front();
  }

private:
  void replace_all()
  {
    for (const auto & goal : goals_) {
      goal->replace();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Pointer> goals_;
  bool open_ = false;
};

/// The base of action servers, whatever their type.
class ActionServerBase
{
public:
  virtual ~ActionServerBase() = default;

  /// Accept goals.
  virtual void start() = 0;

  /// Reject new goals and wait for the current ones to end.
  virtual void stop() = 0;
};

/// Serves an action, one goal at a time; a new goal preempts the current one.
template<typename Action>
class ActionServer : public ActionServerBase
{
public:
  using Execute = std::function<void (Goal<Action> &)>;

  /// Call `execute` with each goal, in the server's own thread.
  ActionServer(
    rclcpp_lifecycle::LifecycleNode & node,
    const std::string & name,
    Execute execute)
  : logger_(node.get_logger()),
    execute_(std::move(execute))
  {
    const auto context = node.get_node_base_interface()->get_context();
    server_ = rclcpp_action::create_server<Action>(
      &node,
      name,
      [goals = goals_](const auto &, const auto &) {
        using Response = rclcpp_action::GoalResponse;
        return goals->is_open() ? Response::ACCEPT_AND_EXECUTE : Response::REJECT;
      },
      [](const auto &) {
        return rclcpp_action::CancelResponse::ACCEPT;
      },
      [goals = goals_, context](const auto & handle) {
        goals->push(std::make_shared<ServedGoal<Action>>(handle, context));
      });
  }

  ~ActionServer() override {end();}

  ActionServer(const ActionServer &) = delete;
  ActionServer & operator=(const ActionServer &) = delete;

  void start() override
  {
    goals_->open();
    thread_ = std::thread(
      [this] {
        while (const auto goal = goals_->front()) {
          work(*goal);
          goals_->pop();
        }
      });
  }

  void stop() override {end();}

private:
  void end()
  {
    goals_->close();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  void work(ServedGoal<Action> & goal)
  {
    try {
      if (goal.cancel_requested()) {
        goal.canceled();
      } else {
        execute_(goal);
      }
    } catch (const std::exception & error) {
      RCLCPP_ERROR(logger_, "The work on a goal failed: %s", error.what());
      goal.abort();
    }
    if (goal.outcome() == Outcome::none) {
      RCLCPP_WARN(logger_, "The work on a goal ended without an outcome: the goal is aborted.");
    }
    try {
      goal.finish();
    } catch (const std::exception & error) {
      RCLCPP_WARN(logger_, "The client was not told of the end of its goal: %s", error.what());
    }
  }

  rclcpp::Logger logger_;
  Execute execute_;
  std::shared_ptr<GoalQueue<Action>> goals_ = std::make_shared<GoalQueue<Action>>();
  std::shared_ptr<rclcpp_action::Server<Action>> server_;
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // ACTION_SERVER_HPP_
