// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// What the logic of idler sees of ROS.
// Generated from serving.ros_package; change the interface there.

#ifndef SERVING__IDLER_INTERFACE_HPP_
#define SERVING__IDLER_INTERFACE_HPP_

#include <functional>

#include "serving/logger.hpp"
#include "serving/time.hpp"

namespace serving
{

/// The parameters, as they are at one moment.
struct IdlerConfig
{
};

/// What the logic may use at any time, from any of its methods.
struct IdlerPassthrough
{
  /// Writes to the log of ROS: log.debug(text), info, warning, error.
  Logger log;

  /// Returns the time of ROS, which can be assigned to the stamp of a message.
  std::function<Time()> now = [] {return Time();};
};

}  // namespace serving

#endif  // SERVING__IDLER_INTERFACE_HPP_
