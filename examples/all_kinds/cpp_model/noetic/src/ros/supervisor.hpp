// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SUPERVISOR_HPP_
#define ROS__SUPERVISOR_HPP_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>

#include "ros/console.h"

#include "stop.hpp"

namespace all_kinds
{

/// Knows when the node stops, whether it has failed, and what of the logic runs; thread-safe.
class Supervisor
{
public:
  using Seconds = Stop::Seconds;

  /// The waits of the logic.
  Stop & waits() {return waits_;}

  /// Set how long the logic may take to return, once the node stops.
  void set_stop_timeout(double seconds)
  {
    if (!(seconds >= 0.0 && seconds <= 3600.0)) {
      throw std::invalid_argument("Parameter stop_timeout must be from 0 to 3600 s.");
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_timeout_ = Seconds(seconds);
  }

  /// Return how long the node may take to end: `stop_timeout` for each thing that it waits for.
  Seconds end_limit() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return 4 * stop_timeout_ + timeouts::END;
  }

  /// Stop the node: end the waits of the logic, then its work.
  void stop()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stopping_) {
      return;
    }
    deadline_ = Stop::deadline(stop_timeout_);
    stopping_ = true;
    waits_.request();
    changed_.notify_all();
  }

  bool stopping() const {return stopping_;}

  /// Return when callbacks must have returned.
  Stop::Clock::time_point deadline() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return deadline_;
  }

  /// Stop a node that cannot go on, and log why.
  void fail(const std::string & reason)
  {
    failed_ = true;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = failure_.empty() ? reason : failure_;
    }
    stop();
    ROS_ERROR("%s", reason.c_str());  // last, as it may wait for the master
  }

  /// Log that the logic refuses a transition: a failure, unless the node has been told to stop.
  void refuse(const char * reason)
  {
    if (!stopping()) {
      fail(reason);
    }
  }

  /// Log what did not return in time; the process then ends without waiting for it.
  void report_late(const std::string & names)
  {
    late_ = true;
    fail("Still running when the node stops: " + names + ".");
  }

  bool late() const {return late_;}

  bool failed() const {return failed_;}

  /// Say where in its life the node is, for diagnostics.
  void set_state(const char * state) {state_ = state;}
  const char * state() const {return state_;}

  /// Return why the node cannot go on.
  std::string failure() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return failure_;
  }

  void wait_for_stop()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] {return stopping();});
  }

  /// Call a callback of the logic; return whether it returned: an exception stops the node.
  template<typename Callback>
  bool guard(const std::string & name, const Callback & callback)
  {
    try {
      callback();
      return true;
    } catch (const std::exception & error) {
      fail("Exception in " + name + ": " + error.what());
    } catch (...) {
      fail("Exception in " + name + ".");
    }
    return false;
  }

  /// Call one of the five methods of the logic; return what it returned, false if it threw.
  template<typename Method>
  bool step(const char * name, const Method & method)
  {
    bool accepted = false;
    enter(name);
    guard(name, [&] {accepted = method();});
    enter(nullptr);
    return accepted;
  }

  /// Say that the last method of the logic has returned.
  void end()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  /// Wait for the end of a node that stops; return false if a method does not return in time.
  bool watch()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_) {
      const auto step = steps_;
      const auto goes_on = [&] {return ended_ || steps_ != step;};
      if (changed_.wait_for(lock, stop_timeout_, goes_on)) {
        continue;
      }
      const std::string name = step_ ? step_ : "callbacks";
      lock.unlock();
      report_late(name);
      waits_.request();
      lock.lock();
      if (!changed_.wait_for(lock, timeouts::RETURN, goes_on)) {
        return false;
      }
    }
    return true;
  }

private:
  void enter(const char * name)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    step_ = name;
    ++steps_;
    if (stopping_) {
      changed_.notify_all();
    }
  }

  Stop waits_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Seconds stop_timeout_{2.0};
  Stop::Clock::time_point deadline_;
  std::atomic<const char *> state_{"unconfigured"};
  std::string failure_;
  const char * step_ = nullptr;
  std::uint64_t steps_ = 0;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> failed_{false};
  std::atomic<bool> late_{false};
  bool ended_ = false;
};

}  // namespace all_kinds

#endif  // ROS__SUPERVISOR_HPP_
