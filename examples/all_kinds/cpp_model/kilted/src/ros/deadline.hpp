// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__DEADLINE_HPP_
#define ROS__DEADLINE_HPP_

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>

#include "timing.hpp"

namespace all_kinds
{

/// Watches a topic, in simulated time or by the steady clock; thread-safe.
class Deadline
{
public:
  /// The topic will be late when no message has come for so long.
  Deadline(const Sleeper & clock, double seconds)
  : clock_(clock),
    seconds_(seconds)
  {
  }

  /// Note that a message has come, and whether the logic is at work with it.
  void heard(bool is_at_work = false)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_at_work_ = is_at_work;
    last_ = now();
    is_late_ = false;
  }

  /// Have the logic handle a message; meanwhile the topic is not late.
  template<typename Receive>
  void handle(const Receive & receive)
  {
    heard(true);
    receive();
    heard();
  }

  /// Call `late` once whenever the topic becomes late, until the node stops.
  template<typename GoesOn, typename Late>
  void watch(const GoesOn & goes_on, const Late & late, const std::string & topic = "")
  {
    if (!clock_.wait_for_start()) {
      return;
    }
    start(topic);
    while (clock_.sleep_for(left()) && goes_on()) {
      if (becomes_late()) {
        late();
      }
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    is_watched_ = false;
  }

  /// Return that the topic is late, and for how long no message has come; empty if it is not.
  std::string complaint()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto silence = this->silence();
    if (!is_watched_ || silence < seconds_) {
      return "";
    }
    char text[32];
    std::snprintf(text, sizeof(text), " for %.1f s", silence);
    return "no message on " + topic_ + text;
  }

private:
  static constexpr double SHORTEST = 0.001;  // s, between two looks

  void start(const std::string & topic)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = now();
    is_late_ = false;
    topic_ = topic;
    is_watched_ = true;
  }

  /// Return how long to sleep: until the topic is late, or for a deadline if it is.
  double left()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto left = seconds_ - silence();
    return left > 0.0 ? std::max(left, SHORTEST) : seconds_;
  }

  bool becomes_late()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_late_ || silence() < seconds_) {
      return false;
    }
    is_late_ = true;
    return true;
  }

  /// Return for how many seconds no message has come.
  double silence()
  {
    const auto time = now();
    last_ = std::min(last_, time);  // the clock may have been set back
    if (is_at_work_) {
      return 0.0;
    }
    return std::chrono::duration<double>(time - last_).count();
  }

  std::chrono::nanoseconds now() const
  {
    if (clock_.is_simulated()) {
      return std::chrono::nanoseconds(clock_.now().nanoseconds());
    }
    return std::chrono::steady_clock::now().time_since_epoch();
  }

  Sleeper clock_;
  double seconds_;
  std::mutex mutex_;
  std::string topic_;
  std::chrono::nanoseconds last_{0};
  bool is_at_work_ = false;
  bool is_late_ = false;
  bool is_watched_ = false;
};

}  // namespace all_kinds

#endif  // ROS__DEADLINE_HPP_
