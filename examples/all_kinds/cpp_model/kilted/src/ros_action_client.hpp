// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_ACTION_CLIENT_HPP_
#define ROS_ACTION_CLIENT_HPP_

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "all_kinds/action_client.hpp"
#include "sent_goal.hpp"

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

  RosActionClient(rclcpp_lifecycle::LifecycleNode & node, const std::string & name)
  : client_(rclcpp_action::create_client<Action>(&node, name))
  {
  }

  ~RosActionClient() override {cancel();}

  bool is_ready() override {return client_->action_server_is_ready();}

  bool send_goal(const Goal & goal) override
  {
    const auto sent = std::make_shared<Sent>();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      sent_ = sent;
    }
    if (!is_ready()) {
      sent->set_state(ActionState::lost);
      return false;
    }
    sent->set_state(ActionState::pending);
    typename rclcpp_action::Client<Action>::SendGoalOptions options;
    options.goal_response_callback = [sent](const HandlePointer & handle) {
        sent->set_handle(handle);
        sent->set_state(handle ? ActionState::active : ActionState::rejected);
      };
    options.feedback_callback =
      [sent](const HandlePointer &, const std::shared_ptr<const Feedback> & feedback) {
        sent->set_feedback(feedback);
      };
    options.result_callback = [sent](const typename Handle::WrappedResult & answer) {
        sent->finish(state_of(answer.code), answer.result);
      };
    client_->async_send_goal(goal, options);
    return true;
  }

  void cancel() override
  {
    const auto goal = sent();
    const auto handle = goal->handle();
    if (!handle || goal->state() != ActionState::active) {
      return;
    }
    try {
      client_->async_cancel_goal(handle);
    } catch (const rclcpp_action::exceptions::UnknownGoalHandleError &) {
      // It ended in this very moment.
    }
  }

  ActionState state() override {return sent()->state();}
  std::shared_ptr<const Feedback> feedback() override {return sent()->feedback();}
  std::shared_ptr<const Result> result() override {return sent()->result();}

private:
  using Handle = rclcpp_action::ClientGoalHandle<Action>;
  using HandlePointer = std::shared_ptr<Handle>;

  class Sent : public SentGoal<Action>
  {
public:
    void set_handle(HandlePointer handle)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      handle_ = std::move(handle);
    }

    HandlePointer handle()
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      return handle_;
    }

private:
    std::mutex mutex_;
    HandlePointer handle_;
  };

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

  std::shared_ptr<Sent> sent()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return sent_;
  }

  std::mutex mutex_;
  std::shared_ptr<Sent> sent_ = std::make_shared<Sent>();
  std::shared_ptr<rclcpp_action::Client<Action>> client_;
};

}  // namespace all_kinds

#endif  // ROS_ACTION_CLIENT_HPP_
