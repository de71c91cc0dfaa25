// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// What the logic of clerk sees of ROS.
// Generated from serving.ros_package; change the interface there.

#ifndef SERVING__CLERK_INTERFACE_HPP_
#define SERVING__CLERK_INTERFACE_HPP_

#include <functional>
#include <string>

#include "serving/goal.hpp"
#include "serving/logger.hpp"
#include "serving/time.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "test_msgs/action/fibonacci.hpp"

namespace serving
{

/// The types of its messages, by names that are the same in every ROS.
namespace clerk_types
{

using GreetService = std_srvs::srv::Trigger;
using OpenService = std_srvs::srv::SetBool;
using CountAction = test_msgs::action::Fibonacci;

}  // namespace clerk_types

/// The parameters, as they are at one moment.
struct ClerkConfig
{
  /// What to say
  std::string greeting = "hello";

  /// Time for a step, s
  double patience = 0.5;
};

/// What the logic may use at any time, from any of its methods.
struct ClerkPassthrough
{
  /// Writes to the log of ROS: log.debug(text), info, warning, error.
  Logger log;

  /// Returns the time of ROS, which can be assigned to the stamp of a message.
  std::function<Time()> now = [] {return Time();};
};

}  // namespace serving

#endif  // SERVING__CLERK_INTERFACE_HPP_
