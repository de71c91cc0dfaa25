// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CALLS_HPP_
#define ROS__CALLS_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace serving
{

/// The calls of the logic that are running; callbacks are let in while it is open.
///
/// Thread-safe. No exception of the logic passes it.
class Calls
{
public:
  using Clock = std::chrono::steady_clock;
  using Pass = std::uint64_t;
  using Report = std::function<void (const std::string & method, const std::string & error)>;

  /// Report every exception of the logic.
  explicit Calls(Report report)
  : report_(std::move(report))
  {
  }

  /// Let callbacks in; report the first exception of one to `on_failure`.
  void open(const std::function<void()> & on_failure)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    on_failure_ = on_failure;
    is_open_ = true;
    ++opening_;
  }

  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    on_failure_ = nullptr;
    is_open_ = false;
  }

  /// Return what lets a callback in until the next `close`, however long it is on its way.
  Pass pass()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return opening_;
  }

  bool is_open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_open_;
  }

  /// Return how often the logic has thrown.
  std::uint64_t failures() const {return failures_;}

  /// Call a callback of the logic; return false if it comes too late or has thrown.
  template<typename Callback>
  bool run(Pass pass, const std::string & method, const Callback & callback)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!is_open_ || pass != opening_) {
        return false;
      }
      running_.push_back(method);
    }
    const bool has_returned = guard(method, callback);
    leave(method);
    return has_returned;
  }

  /// Call the logic; return false if it has thrown.
  template<typename Body>
  bool guard(const std::string & method, const Body & body)
  {
    try {
      body();
      return true;
    } catch (const std::exception & error) {
      fail(method, error.what());
    } catch (...) {
      fail(method, "unknown exception");
    }
    return false;
  }

  /// Count a method as running, whether it is open or not, until `leave`.
  void enter(const std::string & method)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_.push_back(method);
  }

  void leave(const std::string & method)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      running_.erase(std::find(running_.begin(), running_.end(), method));
    }
    changed_.notify_all();
  }

  /// Wait until nothing is running; return false if that takes too long.
  bool wait_until_none(Clock::time_point end)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_until(lock, end, [this] {return running_.empty();});
  }

  /// Return the methods that are running, separated by commas.
  std::string names()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string names;
    for (const auto & method : running_) {
      names += (names.empty() ? "" : ", ") + method;
    }
    return names;
  }

private:
  void fail(const std::string & method, const std::string & error)
  {
    report_(method, error);
    ++failures_;
    const std::lock_guard<std::mutex> lock(mutex_);
    // Under the lock: after `close` nobody is called any more.
    if (const auto on_failure = std::exchange(on_failure_, nullptr)) {
      on_failure();
    }
  }

  Report report_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> running_;
  std::function<void()> on_failure_;
  bool is_open_ = false;
  Pass opening_ = 0;
  std::atomic<std::uint64_t> failures_{0};
};

}  // namespace serving

#endif  // ROS__CALLS_HPP_
