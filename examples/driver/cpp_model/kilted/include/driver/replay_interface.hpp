// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of replay.
// Generated from driver.ros_package; change the interface there.

#ifndef DRIVER__REPLAY_INTERFACE_HPP_
#define DRIVER__REPLAY_INTERFACE_HPP_

#include <functional>
#include <memory>
#include <string>

#include "driver/output_interface.hpp"
#include "driver/ros/logger.hpp"
#include "driver/ros/publisher.hpp"
#include "driver/ros/time.hpp"
#include "std_msgs/msg/float64.hpp"

namespace driver
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace replay_types
{

using PubReading = output_types::PubReading;

}  // namespace replay_types

/// A snapshot of the node's parameters.
struct ReplayConfig : OutputConfig
{
  /// Where the readings are
  std::string file = "readings.txt";
};

/// What the logic can use of ROS, in any of its methods.
struct ReplayPassthrough : OutputPassthrough
{
};

}  // namespace driver

#endif  // DRIVER__REPLAY_INTERFACE_HPP_
