// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SLEEPER_HPP_
#define ROS__SLEEPER_HPP_

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"

#include "stop.hpp"

namespace driving
{

/// Sleeps in ROS time, real or simulated, until the node stops.
class Sleeper
{
public:
  Sleeper(rclcpp::Clock::SharedPtr clock, const std::shared_ptr<Stop> & stop)
  : clock_(std::move(clock)),
    stop_(stop)
  {
    // Every sample of simulated time is a jump.
    rcl_jump_threshold_t threshold;
    threshold.on_clock_change = true;
    threshold.min_forward.nanoseconds = 1;
    threshold.min_backward.nanoseconds = -1;
    jumps_ = clock_->create_jump_callback(
      nullptr,
      [stop](const rcl_time_jump_t &) {
        stop->change([] {});
      },
      threshold);
  }

  rclcpp::Time now() const {return clock_->now();}

  bool is_simulated() const {return clock_->ros_time_is_active();}

  bool sleep_for(double seconds) const
  {
    const auto duration = rclcpp::Duration::from_seconds(std::clamp(seconds, 0.0, 1e9));
    return sleep_until(now() + duration, duration);
  }

  /// Sleep until `due`, but `longest` at most, as the clock may be set back.
  ///
  /// Return false at once when the node stops.
  bool sleep_until(rclcpp::Time due, const rclcpp::Duration & longest) const
  {
    const auto stops = stop_->requests();
    while (!stop_->requested() && stop_->requests() == stops) {
      const auto now = clock_->now();
      if (now >= due) {
        return true;
      }
      due = std::min(due, now + longest);
      // Simulated time may run at any speed: only its samples tell.
      const bool was_simulated = is_simulated();
      const auto end = was_simulated ?
        Stop::deadline(std::chrono::hours(24)) :
        Stop::Clock::now() + (due - now).to_chrono<std::chrono::nanoseconds>();
      stop_->wait_until(
        end, [&] {
          return is_simulated() != was_simulated || (was_simulated && clock_->now() != now);
        });
    }
    return false;
  }

private:
  rclcpp::Clock::SharedPtr clock_;
  std::shared_ptr<Stop> stop_;
  rclcpp::JumpHandler::SharedPtr jumps_;
};

}  // namespace driving

#endif  // ROS__SLEEPER_HPP_
