// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef DRIVER__ROS__PASSTHROUGH_HPP_
#define DRIVER__ROS__PASSTHROUGH_HPP_

#include <functional>
#include <string>

#include "driver/ros/logger.hpp"
#include "driver/ros/time.hpp"

namespace driver
{

/// Clock and logger; a base of the passthrough of every node that uses a group, once.
struct Passthrough
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

}  // namespace driver

#endif  // DRIVER__ROS__PASSTHROUGH_HPP_
