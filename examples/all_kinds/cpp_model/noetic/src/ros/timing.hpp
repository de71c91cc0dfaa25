// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__TIMING_HPP_
#define ROS__TIMING_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <sstream>
#include <string>

#include "ros/node_handle.h"
#include "rosgraph_msgs/Clock.h"

#include "stop.hpp"
#include "supervisor.hpp"

#include "all_kinds/ros/logger.hpp"

namespace all_kinds
{

/// Waits for times: simulated ones as /clock tells them, or those of the steady clock.
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
    return stop_.wait(
      [&] {return now() >= time;},
      [&] {return std::max(time - now(), Nanoseconds(1));});
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
    return stop_.wait(condition, [] {return std::chrono::hours(1);});
  }

  Stop & stop_;
  Nanoseconds simulated_{0};
  ros::Subscriber subscriber_;
};

/// Runs cycles at a fixed frequency; a late one starts at once, those missed are skipped.
class Loop
{
public:
  Loop(Clock & clock, double frequency, const std::string & name = "update")
  : clock_(clock),
    name_(name),
    frequency_(frequency),
    period_(std::chrono::duration_cast<Clock::Nanoseconds>(Stop::Seconds(1.0 / frequency)))
  {
  }

  /// Call `cycle` until the node stops.
  template<typename Cycle>
  void run(const Supervisor & supervisor, const Logger & log, const Cycle & cycle)
  {
    if (!clock_.wait_for_start()) {
      return;
    }
    auto due = clock_.now();
    while (!supervisor.stopping()) {
      if (clock_.is_simulated()) {
        skip(due);  // the cycles between two samples of /clock
      }
      const auto begin = Stop::Clock::now();
      cycle();
      const auto taken = Stop::Clock::now() - begin;
      // The clock may have been set back.
      due = std::min(due, clock_.now()) + period_;
      auto missed = skip(due);
      if (clock_.is_simulated()) {
        // Missed are those that the cycle took, not those that a step of the clock skips.
        missed = std::min<std::int64_t>(missed, (Stop::Clock::now() - begin) / period_);
      }
      report(missed, taken, log);
      clock_.wait_until(due, period_);
    }
  }

  std::uint64_t cycles() const {return cycles_;}
  std::uint64_t late() const {return late_;}
  std::uint64_t missed() const {return missed_;}

private:
  /// Advance `due`, if it has passed, by whole periods; return how many.
  std::int64_t skip(Clock::Nanoseconds & due) const
  {
    const auto periods = std::max((clock_.now() - due) / period_, std::int64_t{0});
    due += periods * period_;
    return periods;
  }

  void report(std::int64_t missed, Clock::Nanoseconds taken, const Logger & log)
  {
    ++cycles_;
    late_ += missed > 0 || taken > period_;
    missed_ += missed;
    unreported_ += missed;
    if (unreported_ > 0 && Stop::Clock::now() >= next_report_) {
      std::ostringstream text;
      text << "Missed " << unreported_ << " cycles of " << frequency_ <<
        " Hz: " << name_ << " takes too long.";
      log.warning(text.str());
      unreported_ = 0;
      next_report_ = Stop::deadline(timeouts::QUIET);
    }
  }

  Clock & clock_;
  std::string name_;
  double frequency_;
  Clock::Nanoseconds period_;
  std::atomic<std::uint64_t> cycles_{0};
  std::atomic<std::uint64_t> late_{0};
  std::atomic<std::uint64_t> missed_{0};
  std::int64_t unreported_ = 0;
  Stop::Clock::time_point next_report_;
};

}  // namespace all_kinds

#endif  // ROS__TIMING_HPP_
