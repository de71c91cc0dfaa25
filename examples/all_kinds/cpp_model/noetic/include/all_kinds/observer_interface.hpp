// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// What the logic of observer sees of ROS.
// Generated from all_kinds.ros_package; change the interface there.

#ifndef ALL_KINDS__OBSERVER_INTERFACE_HPP_
#define ALL_KINDS__OBSERVER_INTERFACE_HPP_

#include <cstdint>
#include <functional>

#include "all_kinds/logger.hpp"
#include "all_kinds/time.hpp"
#include "std_msgs/String.h"

namespace all_kinds
{

/// The types of its messages, by names that are the same in every ROS.
namespace observer_types
{

using InStatus = std_msgs::String;

}  // namespace observer_types

/// The parameters, as they are at one moment.
struct ObserverConfig
{
  /// How many to keep
  std::int64_t limit = 100;
};

/// The messages of one cycle.
///
/// in_<topic>: the latest message received; in_<topic>_updated: whether it is new.
/// out_<topic>: the message to send; out_<topic>_active: whether to send it in this cycle.
struct ObserverData
{
  /// What the worker does
  observer_types::InStatus in_status;
  bool in_status_updated = false;
};

/// What the logic may use at any time, from any of its methods.
struct ObserverPassthrough
{
  /// Writes to the log of ROS: log.debug(text), info, warning, error.
  Logger log;

  /// Returns the time of ROS, which can be assigned to the stamp of a message.
  std::function<Time()> now = [] {return Time();};
};

}  // namespace all_kinds

#endif  // ALL_KINDS__OBSERVER_INTERFACE_HPP_
