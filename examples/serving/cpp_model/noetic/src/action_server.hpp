// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ACTION_SERVER_HPP_
#define ACTION_SERVER_HPP_

#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "actionlib/server/simple_action_server.h"
#include "ros/console.h"
#include "ros/init.h"
#include "ros/node_handle.h"

#include "serving/goal.hpp"

namespace serving
{

/// Serves an action, one goal at a time; a new goal preempts the current one.
template<typename Action>
class ActionServer
{
public:
  /// Call `execute` with each goal, in the server's own thread.
  ActionServer(
    const ros::NodeHandle & node,
    const std::string & name,
    std::function<void(Goal<Action> &)> execute)
  : execute_(std::move(execute)),
    server_(
      node,
      name,
      [this](const boost::shared_ptr<const typename Action::Goal> & goal) {
        work(*goal);
      },
      false)
  {
    server_.start();
  }

private:
  using Server = actionlib::SimpleActionServer<typename Action::Type>;

  class ServedGoal : public Goal<Action>
  {
public:
    ServedGoal(const typename Action::Goal & goal, Server & server)
    : Goal<Action>(goal),
      server_(server)
    {
    }

    bool cancel_requested() override {return server_.isPreemptRequested() || !ros::ok();}
    void publish_feedback() override {server_.publishFeedback(this->feedback);}

private:
    Server & server_;
  };

  void work(const typename Action::Goal & request)
  {
    ServedGoal goal(request, server_);
    try {
      execute_(goal);
    } catch (const std::exception & error) {
      ROS_ERROR("The work on a goal failed: %s", error.what());
      goal.abort();
    }
    switch (goal.outcome()) {
      case Outcome::succeeded:
        server_.setSucceeded(goal.result);
        break;
      case Outcome::canceled:
        server_.setPreempted(goal.result);
        break;
      case Outcome::aborted:
        server_.setAborted(goal.result);
        break;
      case Outcome::none:
        ROS_WARN("The work on a goal ended without an outcome: the goal is aborted.");
        server_.setAborted(goal.result);
        break;
    }
  }

  std::function<void(Goal<Action> &)> execute_;
  Server server_;
};

}  // namespace serving

#endif  // ACTION_SERVER_HPP_
