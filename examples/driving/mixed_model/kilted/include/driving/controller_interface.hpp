// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of controller.
// Generated from driving.ros_package; change the interface there.

#ifndef DRIVING__CONTROLLER_INTERFACE_HPP_
#define DRIVING__CONTROLLER_INTERFACE_HPP_

#include <cstddef>
#include <functional>
#include <string>

#include "driving/ros/logger.hpp"
#include "driving/ros/time.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace driving
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace controller_types
{

using InTargetSpeed = std_msgs::msg::Float64;
using OutSpeed = std_msgs::msg::Float64;
using StopService = std_srvs::srv::Trigger;

}  // namespace controller_types

/// A snapshot of the node's parameters.
struct ControllerConfig
{
  /// Highest speed, m/s
  double speed_limit = 1.0;
};

/// The input and output messages of one cycle.
///
/// in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
/// out_<topic>: the message to publish; out_<topic>_active: whether this cycle publishes it.
/// out_<topic>_subscribers: how many subscribe to it.
struct ControllerData
{
  /// Speed planned, m/s
  controller_types::InTargetSpeed in_target_speed;
  bool in_target_speed_updated = false;

  /// Speed commanded, m/s
  controller_types::OutSpeed out_speed;
  bool out_speed_active = true;
  std::size_t out_speed_subscribers = 0;
};

/// What the logic can use of ROS, in any of its methods.
struct ControllerPassthrough
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

}  // namespace driving

#endif  // DRIVING__CONTROLLER_INTERFACE_HPP_
