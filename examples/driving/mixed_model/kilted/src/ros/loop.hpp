// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__LOOP_HPP_
#define ROS__LOOP_HPP_

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "rclcpp/duration.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"

#include "cycle_counts.hpp"
#include "sleeper.hpp"

namespace driving
{

/// Runs cycles at a fixed frequency of ROS time and skips those it misses.
class Loop
{
public:
  Loop(
    const Sleeper & sleeper,
    double frequency,
    const rclcpp::Logger & logger,
    CycleCounts & counts)
  : sleeper_(sleeper),
    frequency_(frequency),
    period_(rclcpp::Duration::from_seconds(1.0 / frequency)),
    logger_(logger),
    counts_(counts)
  {
  }

  /// Run cycles until the node stops.
  void run(const std::function<void()> & cycle)
  {
    auto due = sleeper_.now();
    while (sleeper_.sleep_until(due, period_)) {
      if (sleeper_.is_simulated()) {
        skip(due);  // those that no sample of /clock is for
      }
      const auto begin = std::chrono::steady_clock::now();
      cycle();
      ++counts_.run;
      // The clock may have been set back.
      due = std::min(due, sleeper_.now()) + period_;
      // A step of the clock is no time that the cycle takes.
      const std::chrono::nanoseconds taken = std::chrono::steady_clock::now() - begin;
      report(std::min<std::int64_t>(skip(due), taken.count() / period_.nanoseconds()));
    }
  }

private:
  /// Move a time that is over on by whole periods; return how many.
  std::int64_t skip(rclcpp::Time & due) const
  {
    const auto late = std::max((sleeper_.now() - due).nanoseconds(), std::int64_t{0});
    const auto periods = late / period_.nanoseconds();
    due += rclcpp::Duration::from_nanoseconds(periods * period_.nanoseconds());
    return periods;
  }

  void report(std::int64_t missed)
  {
    counts_.missed += missed;
    unreported_ += missed;
    const auto now = std::chrono::steady_clock::now();
    if (unreported_ > 0 && now >= next_report_) {
      RCLCPP_WARN(
        logger_,
        "Missed %s cycles of %g Hz: update takes too long.",
        std::to_string(unreported_).c_str(),
        frequency_);
      unreported_ = 0;
      next_report_ = now + std::chrono::seconds(10);
    }
  }

  const Sleeper & sleeper_;
  double frequency_;
  rclcpp::Duration period_;
  rclcpp::Logger logger_;
  CycleCounts & counts_;
  std::int64_t unreported_ = 0;
  std::chrono::steady_clock::time_point next_report_;
};

}  // namespace driving

#endif  // ROS__LOOP_HPP_
