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

#include "driver/output_interface.hpp"
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

using PubReading = output_types::PubReading;

}  // namespace sensor_types

/// A snapshot of the node's parameters.
struct SensorConfig : OutputConfig
{
  /// Where the sensor is
  std::string device = "/dev/ttyUSB0";

  /// Bits a second
  std::int64_t serial_baud = 9600;

  /// How long a reading may take, s
  double serial_timeout = 0.5;
};

/// What the logic can use of ROS, in any of its methods.
struct SensorPassthrough : OutputPassthrough
{
  /// What the logic says of itself on /diagnostics, from any thread.
  std::shared_ptr<LogicStatus> diagnostics = std::make_shared<LogicStatus>();

  /// The node of rclcpp, which outlives the logic, for what the spec cannot say: the logic looks
  /// after what it makes of it.
  rclcpp_lifecycle::LifecycleNode * node = nullptr;
};

}  // namespace driver

#endif  // DRIVER__SENSOR_INTERFACE_HPP_
