// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__LOOP_HPP_
#define ROS__LOOP_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <sstream>

#include "clock.hpp"
#include "supervisor.hpp"

#include "all_kinds/ros/logger.hpp"

namespace all_kinds
{

/// Runs cycles at a fixed frequency; a late one starts at once, those missed are skipped.
class Loop
{
public:
  Loop(Clock & clock, double frequency)
  : clock_(clock),
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
        skip(due);  // those that no sample of /clock is for
      }
      const auto begin = Stop::Clock::now();
      cycle();
      ++cycles_;
      // The clock may have been set back.
      due = std::min(due, clock_.now()) + period_;
      auto missed = skip(due);
      if (clock_.is_simulated()) {
        // A step of it is no time that the cycle takes.
        missed = std::min<std::int64_t>(missed, (Stop::Clock::now() - begin) / period_);
      }
      report(missed, log);
      clock_.wait_until(due, period_);
    }
  }

  std::uint64_t cycles() const {return cycles_;}
  std::uint64_t missed() const {return missed_;}

private:
  /// Move a time that is over on by whole periods; return how many.
  std::int64_t skip(Clock::Nanoseconds & due) const
  {
    const auto periods = std::max((clock_.now() - due) / period_, std::int64_t{0});
    due += periods * period_;
    return periods;
  }

  void report(std::int64_t missed, const Logger & log)
  {
    missed_ += missed;
    unreported_ += missed;
    if (unreported_ > 0 && Stop::Clock::now() >= next_report_) {
      std::ostringstream text;
      text << "Missed " << unreported_ << " cycles of " << frequency_ <<
        " Hz: update takes too long.";
      log.warning(text.str());
      unreported_ = 0;
      next_report_ = Stop::deadline(Stop::Seconds(10.0));
    }
  }

  Clock & clock_;
  double frequency_;
  Clock::Nanoseconds period_;
  std::atomic<std::uint64_t> cycles_{0};
  std::atomic<std::uint64_t> missed_{0};
  std::uint64_t unreported_ = 0;
  Stop::Clock::time_point next_report_;
};

}  // namespace all_kinds

#endif  // ROS__LOOP_HPP_
