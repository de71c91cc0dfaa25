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
#include "std_srvs/SetBool.h"
#include "std_srvs/Trigger.h"
#include "test_msgs/FibonacciAction.h"

namespace serving
{

/// The types of its messages, by names that are the same in every ROS.
namespace clerk_types
{

using GreetService = std_srvs::Trigger;
using OpenService = std_srvs::SetBool;
struct CountAction
{
  using Type = test_msgs::FibonacciAction;
  using Goal = test_msgs::FibonacciGoal;
  using Feedback = test_msgs::FibonacciFeedback;
  using Result = test_msgs::FibonacciResult;
};

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
