// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_ACTION_CLIENT_HPP_
#define ROS__ROS_ACTION_CLIENT_HPP_

#include <memory>
#include <mutex>
#include <string>

#include "actionlib/goal_id_generator.h"
#include "actionlib_msgs/GoalID.h"
#include "actionlib_msgs/GoalStatusArray.h"
#include "ros/node_handle.h"

#include "all_kinds/ros/action_client.hpp"
#include "sent_goal.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// Sends goals to an action server and tracks them without blocking.
///
/// It speaks the protocol of actionlib, as the client of actionlib 1.14 blocks until the first
/// /clock when it is made.
template<typename Action>
class RosActionClient : public ActionClient<Action>
{
public:
  using typename ActionClient<Action>::Goal;
  using typename ActionClient<Action>::Feedback;
  using typename ActionClient<Action>::Result;

  RosActionClient(const ros::NodeHandle & node, const std::string & name)
  : node_(node, name),
    goals_(node_.advertise<ActionGoal>("goal", QUEUE)),
    cancels_(node_.advertise<actionlib_msgs::GoalID>("cancel", QUEUE)),
    status_(node_.subscribe("status", QUEUE, &RosActionClient::take_status, this)),
    feedback_(node_.subscribe("feedback", QUEUE, &RosActionClient::take_feedback, this)),
    results_(node_.subscribe("result", QUEUE, &RosActionClient::take_result, this)),
    timer_(
      node_.createWallTimer(
        ros::WallDuration(Stop::Seconds(timeouts::WATCH).count()),
        [this](const ros::WallTimerEvent &) {
          check_server();
        }))
  {
  }

  bool is_ready() override
  {
    return goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0 &&
           feedback_.getNumPublishers() > 0 && results_.getNumPublishers() > 0;
  }

  bool send_goal(const Goal & goal) override
  {
    cancel();
    const std::lock_guard<std::mutex> lock(mutex_);
    sent_ = std::make_shared<SentGoal<Action>>();
    if (!is_ready()) {
      sent_->set_state(ActionState::lost);
      return false;
    }
    sent_->set_state(ActionState::pending);
    ActionGoal message;
    message.header.stamp = ros::Time::now();
    message.goal_id = id_ = ids_.generateID();
    message.goal = goal;
    goals_.publish(message);
    return true;
  }

  /// Servers of actionlib keep a cancel that comes before its goal.
  void cancel() override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_under_way()) {
      actionlib_msgs::GoalID message;
      message.id = id_.id;
      cancels_.publish(message);
    }
  }

  ActionState state() override {return sent()->state();}
  std::shared_ptr<const Feedback> feedback() override {return sent()->feedback();}
  std::shared_ptr<const Result> result() override {return sent()->result();}

private:
  using ActionGoal = typename Action::Type::_action_goal_type;
  using ActionFeedback = typename Action::Type::_action_feedback_type;
  using ActionResult = typename Action::Type::_action_result_type;
  using Status = actionlib_msgs::GoalStatus;

  static constexpr std::uint32_t QUEUE = 50;  // messages kept for a topic

  void take_status(const actionlib_msgs::GoalStatusArrayConstPtr & statuses)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!is_under_way()) {
      return;
    }
    for (const auto & status : statuses->status_list) {
      if (status.goal_id.id == id_.id) {
        if (status.status != Status::PENDING && status.status != Status::RECALLING) {
          sent_->set_state(ActionState::active);
        }
        return;
      }
    }
    if (sent_->state() == ActionState::active) {  // the server has been started anew
      sent_->set_state(ActionState::lost);
    }
  }

  void take_feedback(const boost::shared_ptr<const ActionFeedback> & message)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_under_way() && message->status.goal_id.id == id_.id) {
      sent_->set_feedback(part_of(message, message->feedback));
    }
  }

  void take_result(const boost::shared_ptr<const ActionResult> & message)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_under_way() && message->status.goal_id.id == id_.id) {
      sent_->finish(state_of(message->status), part_of(message, message->result));
    }
  }

  /// Notice a server that has died.
  void check_server()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_under_way() && !is_ready()) {
      sent_->set_state(ActionState::lost);
    }
  }

  bool is_under_way()
  {
    const auto state = sent_->state();
    return state == ActionState::pending || state == ActionState::active;
  }

  static ActionState state_of(const Status & status)
  {
    switch (status.status) {
      case Status::REJECTED:
        return ActionState::rejected;
      case Status::SUCCEEDED:
        return ActionState::succeeded;
      case Status::ABORTED:
        return ActionState::aborted;
      case Status::PREEMPTED:
      case Status::RECALLED:
        return ActionState::canceled;
      default:
        return ActionState::lost;
    }
  }

  /// Return a part of a message that keeps the whole alive.
  template<typename Message, typename Part>
  static std::shared_ptr<const Part> part_of(
    const boost::shared_ptr<const Message> & message,
    const Part & part)
  {
    return std::shared_ptr<const Part>(&part, [message](const Part *) {});
  }

  std::shared_ptr<SentGoal<Action>> sent()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return sent_;
  }

  std::mutex mutex_;
  std::shared_ptr<SentGoal<Action>> sent_ = std::make_shared<SentGoal<Action>>();
  actionlib_msgs::GoalID id_;
  actionlib::GoalIDGenerator ids_;
  ros::NodeHandle node_;
  ros::Publisher goals_;
  ros::Publisher cancels_;
  ros::Subscriber status_;
  ros::Subscriber feedback_;
  ros::Subscriber results_;
  ros::WallTimer timer_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_ACTION_CLIENT_HPP_
