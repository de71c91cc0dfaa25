// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__GOAL_THREADS_HPP_
#define ROS__GOAL_THREADS_HPP_

#include <list>
#include <mutex>
#include <string>
#include <utility>

#include "calls.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// The threads of an action: one for all its goals, or, if they are parallel, one for each.
class GoalThreads
{
public:
  GoalThreads(const std::string & name, bool is_parallel)
  : name_(name),
    is_parallel_(is_parallel)
  {
  }

  /// Run a job at once if goals are parallel, else after those before it.
  void post(JobThread::Job job)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_parallel_) {
      const auto has_ended = [](auto & thread) {return thread.wait_until_idle(Stop::Clock::now());};
      threads_.remove_if(has_ended);
    }
    if (is_parallel_ || threads_.empty()) {
      threads_.emplace_back(name_);
    }
    threads_.back().post(std::move(job));
  }

  /// Run the jobs that are left; threads that are late go on by themselves.
  void end_by(Stop::Clock::time_point end)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto & thread : threads_) {
      thread.end_by(end);
    }
  }

private:
  const std::string name_;
  const bool is_parallel_;
  std::mutex mutex_;
  std::list<JobThread> threads_;
};

}  // namespace all_kinds

#endif  // ROS__GOAL_THREADS_HPP_
