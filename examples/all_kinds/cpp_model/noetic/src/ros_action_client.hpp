// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_ACTION_CLIENT_HPP_
#define ROS_ACTION_CLIENT_HPP_

#include <memory>
#include <mutex>
#include <string>

#include "actionlib/client/simple_action_client.h"
#include "ros/node_handle.h"

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

  RosActionClient(ros::NodeHandle node, const std::string & name)
  : client_(node, name, false)
  {
  }

  bool is_ready() override {return client_.isServerConnected();}

  bool send_goal(const Goal & goal) override
  {
    const auto sent = std::make_shared<SentGoal<Action>>();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      sent_ = sent;
    }
    if (!is_ready()) {
      sent->set_state(ActionState::lost);
      return false;
    }
    sent->set_state(ActionState::pending);
    client_.sendGoal(
      goal,
      [sent](const actionlib::SimpleClientGoalState & state, const ResultPointer & result) {
        sent->finish(state_of(state), as_standard(result));
      },
      [sent] {
        sent->set_state(ActionState::active);
      },
      [sent](const FeedbackPointer & feedback) {
        sent->set_feedback(as_standard(feedback));
      });
    return true;
  }

  void cancel() override
  {
    const auto current = state();
    if (current == ActionState::pending || current == ActionState::active) {
      client_.cancelGoal();
    }
  }

  ActionState state() override {return sent()->state();}
  std::shared_ptr<const Feedback> feedback() override {return sent()->feedback();}
  std::shared_ptr<const Result> result() override {return sent()->result();}

private:
  using FeedbackPointer = boost::shared_ptr<const Feedback>;
  using ResultPointer = boost::shared_ptr<const Result>;

  static ActionState state_of(const actionlib::SimpleClientGoalState & state)
  {
    switch (state.state_) {
      case actionlib::SimpleClientGoalState::REJECTED:
        return ActionState::rejected;
      case actionlib::SimpleClientGoalState::SUCCEEDED:
        return ActionState::succeeded;
      case actionlib::SimpleClientGoalState::ABORTED:
        return ActionState::aborted;
      case actionlib::SimpleClientGoalState::PREEMPTED:
      case actionlib::SimpleClientGoalState::RECALLED:
        return ActionState::canceled;
      default:
        return ActionState::lost;
    }
  }

  template<typename Message>
  static std::shared_ptr<const Message> as_standard(const boost::shared_ptr<const Message> & from)
  {
    return std::shared_ptr<const Message>(from.get(), [from](const Message *) {});
  }

  std::shared_ptr<SentGoal<Action>> sent()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return sent_;
  }

  std::mutex mutex_;
  std::shared_ptr<SentGoal<Action>> sent_ = std::make_shared<SentGoal<Action>>();
  actionlib::SimpleActionClient<typename Action::Type> client_;
};

}  // namespace all_kinds

#endif  // ROS_ACTION_CLIENT_HPP_
