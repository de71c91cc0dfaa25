// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of sensor.
// Generated from driver.ros_package; change the interface there.

#ifndef DRIVER__SENSOR_INTERFACE_HPP_
#define DRIVER__SENSOR_INTERFACE_HPP_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "driver/ros/logger.hpp"
#include "driver/ros/logic_status.hpp"
#include "driver/ros/publisher.hpp"
#include "driver/ros/time.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/float64.hpp"

namespace driver
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace sensor_types
{

using PubReading = std_msgs::msg::Float64;

}  // namespace sensor_types

/// A snapshot of the node's parameters.
struct SensorConfig
{
  /// Where the sensor is
  std::string device = "/dev/ttyUSB0";

  /// Bits a second
  std::int64_t serial_baud = 9600;

  /// How long a reading may take, s
  double serial_timeout = 0.5;
};

/// Publishers, clients, transforms, clock and logger, for use in any method of the logic.
struct SensorPassthrough
{
  /// The node's logger: log.debug(text), log.info, log.warning, log.error; to write once:
  /// log.info_once(text); at most every two seconds: log.info_throttle(2.0, text).
  Logger log;

  /// Returns the ROS time; it converts to a message's stamp and back.
  std::function<Time()> now = [] {return Time();};

  /// Waits that many seconds of ROS time; returns false at once when the node stops.
  std::function<bool(double)> sleep = [](double) {return true;};

  /// Has the node stop as an exception does, from any thread; the reason goes to the log.
  std::function<void(const std::string &)> fail = [](const std::string &) {};

  /// What the logic says of itself on /diagnostics, from any thread.
  std::shared_ptr<LogicStatus> diagnostics = std::make_shared<LogicStatus>();

  /// The node of rclcpp, which outlives the logic, for what the spec cannot say: the logic looks
  /// after what it
  /// makes of it.
  rclcpp_lifecycle::LifecycleNode * node = nullptr;

  /// What was measured, m
  std::shared_ptr<Publisher<sensor_types::PubReading>> pub_reading =
    std::make_shared<Publisher<sensor_types::PubReading>>();
};

}  // namespace driver

#endif  // DRIVER__SENSOR_INTERFACE_HPP_
