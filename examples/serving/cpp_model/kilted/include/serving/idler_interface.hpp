// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The interface between ROS and the logic of idler.
// Generated from serving.ros_package; change the interface there.

#ifndef SERVING__IDLER_INTERFACE_HPP_
#define SERVING__IDLER_INTERFACE_HPP_

#include <functional>
#include <string>

#include "serving/ros/logger.hpp"
#include "serving/ros/time.hpp"

namespace serving
{

/// A snapshot of the node's parameters.
struct IdlerConfig
{
};

/// What the logic can use of ROS, in any of its methods.
struct IdlerPassthrough
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

#endif  // SERVING__IDLER_INTERFACE_HPP_
