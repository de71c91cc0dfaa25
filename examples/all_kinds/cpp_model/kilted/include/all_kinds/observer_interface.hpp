// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of observer.
// Generated from all_kinds.ros_package; change the interface there.

#ifndef ALL_KINDS__OBSERVER_INTERFACE_HPP_
#define ALL_KINDS__OBSERVER_INTERFACE_HPP_

#include <cstdint>
#include <functional>
#include <string>

#include "all_kinds/ros/logger.hpp"
#include "all_kinds/ros/time.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "std_msgs/msg/string.hpp"

namespace all_kinds
{

/// Message, service and action types, under the same names in ROS 1 and ROS 2.
namespace observer_types
{

using InStatus = std_msgs::msg::String;
using PairLeft = geometry_msgs::msg::PointStamped;
using PairRight = geometry_msgs::msg::PointStamped;

/// Messages whose stamps belong together, for receive_pair: valid until it returns.
struct PairMessages
{
  /// The left side
  const PairLeft & left;

  /// The right side
  const PairRight & right;
};

}  // namespace observer_types

/// A snapshot of the node's parameters.
struct ObserverConfig
{
  /// How many to keep
  std::int64_t limit = 100;
};

/// The input and output messages of one cycle.
///
/// in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
struct ObserverData
{
  /// What the worker does
  observer_types::InStatus in_status;
  bool in_status_updated = false;
};

/// What the logic can use of ROS, in any of its methods.
struct ObserverPassthrough
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

}  // namespace all_kinds

#endif  // ALL_KINDS__OBSERVER_INTERFACE_HPP_
