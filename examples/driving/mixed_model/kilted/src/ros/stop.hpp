// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__STOP_HPP_
#define ROS__STOP_HPP_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace driving
{

/// Ends every wait of the logic when the node stops; thread-safe.
class Stop
{
public:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  /// Return when a timeout of wall time ends; a day is as good as for ever.
  static Clock::time_point deadline(Seconds timeout)
  {
    const Seconds bounded = std::clamp(timeout, Seconds::zero(), Seconds(std::chrono::hours(24)));
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(bounded);
  }

  /// End all waits, and at once those that begin before `clear`.
  void request()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      requested_ = true;
      ++requests_;
    }
    changed_.notify_all();
  }

  /// Let new waits wait again; those of before have ended.
  void clear()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requested_ = false;
  }

  bool requested() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return requested_;
  }

  /// Return how often it was requested: a wait of several parts ends when that grows.
  std::uint64_t requests() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return requests_;
  }

  /// Wait until a condition holds; return false at the end of the time or when the node stops.
  template<typename Condition>
  bool wait_until(Clock::time_point end, const Condition & condition)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto requests = requests_;
    const auto is_over = [&] {return requested_ || requests != requests_;};
    changed_.wait_until(lock, end, [&] {return is_over() || condition();});
    return !is_over() && condition();
  }

  /// Read what `change` may change.
  template<typename Value>
  auto read(const Value & value) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value();
  }

  /// Make a change that a condition waits for.
  template<typename Change>
  void change(const Change & change)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      change();
    }
    changed_.notify_all();
  }

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool requested_ = false;
  std::uint64_t requests_ = 0;
};

}  // namespace driving

#endif  // ROS__STOP_HPP_
