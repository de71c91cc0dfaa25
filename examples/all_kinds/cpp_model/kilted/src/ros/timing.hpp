// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__TIMING_HPP_
#define ROS__TIMING_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/time.hpp"

#include "stop.hpp"

namespace all_kinds
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
    const auto wake_up = [stop](const rcl_time_jump_t &) {stop->change([] {});};
    jumps_ = clock_->create_jump_callback(nullptr, wake_up, threshold);
  }

  rclcpp::Time now() const {return clock_->now();}
  bool is_simulated() const {return clock_->ros_time_is_active();}

  /// Wait for the first /clock where time is simulated; return false when the node stops.
  bool wait_for_start() const
  {
    const auto has_started = [this] {return !is_simulated() || now().nanoseconds() > 0;};
    return stop_->wait(has_started, [] {return std::chrono::hours(1);});
  }

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
    const auto is_due = [&] {
        due = std::min(due, now() + longest);
        return now() >= due;
      };
    const auto time_left = [&] {
        // Simulated time may run at any speed: each sample wakes this thread up.
        return is_simulated() ? std::chrono::hours(1) : std::max(
          (due - now()).to_chrono<std::chrono::nanoseconds>(), std::chrono::nanoseconds(1));
      };
    return stop_->wait(is_due, time_left);
  }

private:
  rclcpp::Clock::SharedPtr clock_;
  std::shared_ptr<Stop> stop_;
  rclcpp::JumpHandler::SharedPtr jumps_;
};

/// Runs cycles at a fixed frequency of ROS time and skips those it misses.
class Loop
{
public:
  Loop(
    const Sleeper & sleeper,
    double frequency,
    const rclcpp::Logger & logger,
    const std::string & name = "update")
  : sleeper_(sleeper),
    name_(name),
    frequency_(frequency),
    period_(rclcpp::Duration::from_seconds(1.0 / frequency)),
    logger_(logger)
  {
  }

  /// Run cycles until the node stops, or until one returns false.
  void run(const std::function<bool()> & cycle)
  {
    if (!sleeper_.wait_for_start()) {
      return;
    }
    auto due = sleeper_.now();
    while (sleeper_.sleep_until(due, period_)) {
      if (sleeper_.is_simulated()) {
        skip(due);  // the cycles between two samples of /clock
      }
      const auto begin = std::chrono::steady_clock::now();
      if (!cycle()) {
        return;
      }
      // The clock may have been set back.
      due = std::min(due, sleeper_.now()) + period_;
      // Missed are those that the cycle took, not those that a step of the clock skips.
      const std::chrono::nanoseconds taken = std::chrono::steady_clock::now() - begin;
      report(std::min<std::int64_t>(skip(due), taken.count() / period_.nanoseconds()), taken);
    }
  }

  /// How many cycles have run, how many took too long for the next to begin in time, and how many
  /// were missed, since the start of the node.
  std::uint64_t cycles() const {return cycles_;}
  std::uint64_t late() const {return late_;}
  std::uint64_t missed() const {return missed_;}

private:
  /// Advance `due`, if it has passed, by whole periods; return how many.
  std::int64_t skip(rclcpp::Time & due) const
  {
    const auto late = std::max((sleeper_.now() - due).nanoseconds(), std::int64_t{0});
    const auto periods = late / period_.nanoseconds();
    due += rclcpp::Duration::from_nanoseconds(periods * period_.nanoseconds());
    return periods;
  }

  void report(std::int64_t missed, std::chrono::nanoseconds taken)
  {
    ++cycles_;
    late_ += missed > 0 || taken.count() > period_.nanoseconds();
    missed_ += missed;
    unreported_ += missed;
    const auto now = std::chrono::steady_clock::now();
    if (unreported_ > 0 && now >= next_report_) {
      const auto count = std::to_string(unreported_);
      RCLCPP_WARN(
        logger_, "Missed %s cycles of %g Hz: %s takes too long.",
        count.c_str(), frequency_, name_.c_str());
      unreported_ = 0;
      next_report_ = now + timeouts::QUIET;
    }
  }

  Sleeper sleeper_;
  std::string name_;
  double frequency_;
  rclcpp::Duration period_;
  rclcpp::Logger logger_;
  std::atomic<std::uint64_t> cycles_{0};
  std::atomic<std::uint64_t> late_{0};
  std::atomic<std::uint64_t> missed_{0};
  std::int64_t unreported_ = 0;
  std::chrono::steady_clock::time_point next_report_;
};

}  // namespace all_kinds

#endif  // ROS__TIMING_HPP_
