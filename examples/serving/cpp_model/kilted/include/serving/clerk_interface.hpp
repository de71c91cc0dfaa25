// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of clerk.
// Generated from serving.ros_package; change the interface there.

#ifndef SERVING__CLERK_INTERFACE_HPP_
#define SERVING__CLERK_INTERFACE_HPP_

#include <functional>
#include <string>

#include "serving/ros/goal.hpp"
#include "serving/ros/logger.hpp"
#include "serving/ros/time.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "test_msgs/action/fibonacci.hpp"

namespace serving
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace clerk_types
{

using GreetService = std_srvs::srv::Trigger;
using OpenService = std_srvs::srv::SetBool;
using CountAction = test_msgs::action::Fibonacci;

}  // namespace clerk_types

/// A snapshot of the node's parameters.
struct ClerkConfig
{
  /// What to say
  std::string greeting = "hello";

  /// Time for a step, s
  double patience = 0.5;
};

/// What the logic can use of ROS, in any of its methods.
struct ClerkPassthrough
{
  /// The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
  /// log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
  Logger log;

  /// Returns the ROS time; it converts to a message's stamp and back.
  std::function<Time()> now = [] {return Time();};

  /// Waits that many seconds of ROS time; returns false at once when the node stops.
  std::function<bool(double)> sleep = [](double) {return true;};

  /// Stops the node with an error, as an exception would, from any thread; logs the reason.
  std::function<void(const std::string &)> fail = [](const std::string &) {};
};

}  // namespace serving

#endif  // SERVING__CLERK_INTERFACE_HPP_
