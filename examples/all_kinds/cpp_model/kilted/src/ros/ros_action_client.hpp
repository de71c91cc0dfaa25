// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_ACTION_CLIENT_HPP_
#define ROS__ROS_ACTION_CLIENT_HPP_

#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "rclcpp/create_timer.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

#include "all_kinds/ros/action_client.hpp"
#include "managed_node.hpp"
#include "tracked_goal.hpp"

namespace all_kinds
{

/// Sends goals to an action server and tracks them without blocking.
template<typename Action>
class RosActionClient : public ActionClient<Action>
{
public:
  using typename ActionClient<Action>::Goal;
  using typename ActionClient<Action>::Feedback;
  using typename ActionClient<Action>::Result;

  RosActionClient(ManagedNode & node, const std::string & name)
  : client_(
      std::make_shared<Client>(
        node.get_node_base_interface(),
        node.get_node_graph_interface(),
        node.get_node_logging_interface(),
        name)),
    watchdog_(
      rclcpp::create_wall_timer(
        timeouts::WATCH,
        [goal = goal_, client = std::weak_ptr<Client>(client_)] {
          goal->get()->watch(is_ready(client.lock()));
        },
        node.callback_group("action", name),
        node.get_node_base_interface().get(),
        node.get_node_timers_interface().get()))
  {
    // Not by rclcpp_action::create_client, whose deleter (29.3) locks the callback group: when an
    // executor is the last to hold the client, it has locked the group and waits for itself.
    const auto group = node.callback_group("action", name);
    node.get_node_waitables_interface()->add_waitable(client_, group);
    client_ = waking(std::move(client_), group);
  }

  bool is_ready() override {return is_ready(client_);}

  bool send_goal(const Goal & goal) override
  {
    cancel();
    const auto sent = std::make_shared<Tracked>();
    goal_->set(sent);
    if (!is_ready()) {
      sent->end(ActionState::lost);
      return false;
    }
    sent->set_state(ActionState::pending);
    try {
      client_->async_send_goal(goal, options(sent));
      return true;
    } catch (const std::exception &) {
      sent->end(ActionState::lost);  // The context is shut down.
      return false;
    }
  }

  void cancel() override
  {
    const auto goal = goal_->get();
    if (const auto handle = goal->want_cancel()) {
      request_cancel(client_, handle, goal);
    }
  }

  /// Cancel the goal and wait until the server has answered that.
  void cancel_until(std::chrono::steady_clock::time_point end)
  {
    cancel();
    if (is_ready()) {
      goal_->get()->wait_until_canceled(end);
    }
  }

  ActionState state() override {return goal_->get()->state();}
  std::shared_ptr<const Feedback> feedback() override {return goal_->get()->feedback();}
  std::shared_ptr<const Result> result() override {return goal_->get()->result();}

private:
  using Client = rclcpp_action::Client<Action>;
  using Handle = rclcpp_action::ClientGoalHandle<Action>;
  using HandlePointer = std::shared_ptr<Handle>;
  using Tracked = TrackedGoal<Action, HandlePointer>;

  /// The goal that was sent last; thread-safe.
  class Latest
  {
public:
    std::shared_ptr<Tracked> get()
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      return goal_;
    }

    void set(const std::shared_ptr<Tracked> & goal)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      goal_ = goal;
    }

private:
    std::mutex mutex_;
    std::shared_ptr<Tracked> goal_ = std::make_shared<Tracked>();
  };

  /// Return the callbacks of a goal, which must not own it: it owns its handle, which owns them.
  typename Client::SendGoalOptions options(const std::weak_ptr<Tracked> & sent)
  {
    typename Client::SendGoalOptions options;
    options.goal_response_callback =
      [sent, client = std::weak_ptr<Client>(client_)](const HandlePointer & handle) {
        const auto goal = sent.lock();
        // A goal that was replaced in the meantime is not wanted any more.
        if (handle && (!goal || goal->accept(handle))) {
          request_cancel(client.lock(), handle, goal);
        } else if (goal && !handle) {
          goal->end(ActionState::rejected);
        }
      };
    options.feedback_callback =
      [sent](const HandlePointer &, const std::shared_ptr<const Feedback> & feedback) {
        if (const auto goal = sent.lock()) {
          goal->set_feedback(feedback);
        }
      };
    options.result_callback = [sent](const typename Handle::WrappedResult & answer) {
        if (const auto goal = sent.lock()) {
          goal->end(state_of(answer.code), answer.result);
        }
      };
    return options;
  }

  static bool is_ready(const std::shared_ptr<Client> & client)
  {
    try {
      return client && client->action_server_is_ready();
    } catch (const std::exception &) {
      return false;  // The context is shut down.
    }
  }

  static void request_cancel(
    const std::shared_ptr<Client> & client,
    const HandlePointer & handle,
    const std::weak_ptr<Tracked> & sent)
  {
    if (!client) {
      return;
    }
    try {
      client->async_cancel_goal(
        handle, [sent](const auto &) {
          if (const auto goal = sent.lock()) {
            goal->set_cancel_answered();
          }
        });
    } catch (const std::exception &) {
      // The goal has just ended, or the context is shut down.
    }
  }

  static ActionState state_of(rclcpp_action::ResultCode code)
  {
    switch (code) {
      case rclcpp_action::ResultCode::SUCCEEDED:
        return ActionState::succeeded;
      case rclcpp_action::ResultCode::ABORTED:
        return ActionState::aborted;
      case rclcpp_action::ResultCode::CANCELED:
        return ActionState::canceled;
      default:
        return ActionState::lost;
    }
  }

  std::shared_ptr<Latest> goal_ = std::make_shared<Latest>();
  std::shared_ptr<Client> client_;
  rclcpp::TimerBase::SharedPtr watchdog_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_ACTION_CLIENT_HPP_
