// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CLOCK_HPP_
#define ROS__CLOCK_HPP_

#include <algorithm>
#include <chrono>

#include "ros/node_handle.h"
#include "rosgraph_msgs/Clock.h"

#include "stop.hpp"

namespace all_kinds
{

/// Waits for times: simulated ones as /clock tells them, or those of a clock that is never set.
class Clock
{
public:
  using Nanoseconds = std::chrono::nanoseconds;

  Clock(ros::NodeHandle & node, Stop & stop)
  : stop_(stop)
  {
    if (ros::Time::isSimTime()) {
      subscriber_ = node.subscribe<rosgraph_msgs::Clock>(
        "/clock",
        1,
        [this](const rosgraph_msgs::ClockConstPtr & message) {
          stop_.change([&] {simulated_ = Nanoseconds(message->clock.toNSec());});
        });
    }
  }

  bool is_simulated() const {return static_cast<bool>(subscriber_);}

  Nanoseconds now()
  {
    if (is_simulated()) {
      return stop_.read([this] {return simulated_;});
    }
    return std::chrono::steady_clock::now().time_since_epoch();
  }

  /// Wait for the first /clock where time is simulated; return false when the node stops.
  bool wait_for_start()
  {
    return !is_simulated() || wait([this] {return simulated_ > Nanoseconds::zero();});
  }

  /// Wait until `time`, but `longest` at most, as the clock may be set back.
  ///
  /// Return false when the node stops.
  bool wait_until(Nanoseconds time, Nanoseconds longest)
  {
    if (is_simulated()) {
      return wait(
        [&] {
          time = std::min(time, simulated_ + longest);
          return simulated_ >= time;
        });
    }
    stop_.wait_until(Stop::Clock::time_point(time), [] {return false;});
    return !stop_.requested();
  }

  /// Wait some seconds; return false at once when the node stops.
  bool sleep(double seconds)
  {
    const Stop::Seconds bounded(std::clamp(seconds, 0.0, 1e9));
    const auto duration = std::chrono::duration_cast<Nanoseconds>(bounded);
    return wait_until(now() + duration, duration);
  }

private:
  template<typename Condition>
  bool wait(const Condition & condition)
  {
    while (!stop_.requested()) {
      if (stop_.wait_until(Stop::deadline(std::chrono::hours(1)), condition)) {
        return true;
      }
    }
    return false;
  }

  Stop & stop_;
  Nanoseconds simulated_{0};
  ros::Subscriber subscriber_;
};

}  // namespace all_kinds

#endif  // ROS__CLOCK_HPP_
