// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef LOOP_HPP_
#define LOOP_HPP_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "rclcpp/clock.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace all_kinds
{

/// A thread that runs update at a fixed frequency and skips missed cycles.
class Loop
{
public:
  /// Start the thread; the frequency is in Hz of the node's clock.
  Loop(
    rclcpp_lifecycle::LifecycleNode & node,
    double frequency,
    const std::function<void()> & cycle)
  : clock_(node.get_clock()),
    context_(node.get_node_base_interface()->get_context()),
    period_(rclcpp::Duration::from_seconds(1.0 / frequency)),
    thread_([this, cycle] {run(cycle);})
  {
  }

  /// Join the thread, after the current cycle.
  ~Loop()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopped_ = true;
    }
    stop_.notify_one();
    thread_.join();
  }

  Loop(const Loop &) = delete;
  Loop & operator=(const Loop &) = delete;

private:
  void run(const std::function<void()> & cycle)
  {
    auto due = clock_->now();
    while (sleep_until(due) && context_->is_valid()) {
      cycle();
      due = std::max(due + period_, clock_->now());
    }
  }

  /// Sleep until `due`, a period at most; return false when stopped.
  bool sleep_until(rclcpp::Time & due)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!stopped_) {
      const auto now = clock_->now();
      if (now >= due) {
        return true;
      }
      // A clock set back must not stall the loop.
      due = std::min(due, now + period_);
      auto pause = (due - now).to_chrono<std::chrono::nanoseconds>();
      if (clock_->ros_time_is_active()) {
        // Simulated time may run at any speed.
        pause = std::min<std::chrono::nanoseconds>(pause, std::chrono::milliseconds(1));
      }
      stop_.wait_for(lock, pause);
    }
    return false;
  }

  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Context::SharedPtr context_;
  rclcpp::Duration period_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // LOOP_HPP_
