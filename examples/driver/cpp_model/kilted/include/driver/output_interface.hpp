// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// What the nodes with the group output have in common.
// Generated from driver.ros_package; change the interface there.

#ifndef DRIVER__OUTPUT_INTERFACE_HPP_
#define DRIVER__OUTPUT_INTERFACE_HPP_

#include <functional>
#include <memory>
#include <string>

#include "driver/ros/logger.hpp"
#include "driver/ros/passthrough.hpp"
#include "driver/ros/publisher.hpp"
#include "driver/ros/time.hpp"
#include "std_msgs/msg/float64.hpp"

namespace driver
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace output_types
{

using PubReading = std_msgs::msg::Float64;

}  // namespace output_types

/// A snapshot of the parameters of the group.
struct OutputConfig
{
  /// How long one unit of the sensor is, m
  double scale = 1.0;
};

/// What the logic can use of ROS, in any of its methods.
struct OutputPassthrough : virtual Passthrough
{
  /// What was measured, m
  std::shared_ptr<Publisher<output_types::PubReading>> pub_reading =
    std::make_shared<Publisher<output_types::PubReading>>();
};

}  // namespace driver

#endif  // DRIVER__OUTPUT_INTERFACE_HPP_
