// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__JOB_THREAD_HPP_
#define ROS__JOB_THREAD_HPP_

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "thread_name.hpp"

namespace driving
{

/// A thread that runs jobs in their order.
class JobThread
{
public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void ()>;

  explicit JobThread(const std::string & name)
  : thread_(
      [queue = queue_, name] {
        name_this_thread(name);
        queue->work();
      })
  {
  }

  /// Run the jobs that are left, then join the thread.
  ~JobThread()
  {
    if (thread_.joinable()) {
      queue_->close();
      thread_.join();
    }
  }

  /// Run the jobs that are left.
  ///
  /// A thread that is late is left to itself: its jobs must own all they use.
  void end_by(Clock::time_point end)
  {
    queue_->close();
    if (queue_->wait_until_idle(end)) {
      thread_.join();
    } else {
      thread_.detach();
    }
  }

  JobThread(const JobThread &) = delete;
  JobThread & operator=(const JobThread &) = delete;

  void post(Job job) {queue_->push(std::move(job));}

  /// Wait until no job is running or waiting; return false if that takes too long.
  bool wait_until_idle(Clock::time_point end) {return queue_->wait_until_idle(end);}

private:
  class Queue
  {
public:
    void push(Job job)
    {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        jobs_.push_back(std::move(job));
      }
      changed_.notify_all();
    }

    void close()
    {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_closed_ = true;
      }
      changed_.notify_all();
    }

    bool wait_until_idle(Clock::time_point end)
    {
      std::unique_lock<std::mutex> lock(mutex_);
      return changed_.wait_until(lock, end, [this] {return jobs_.empty();});
    }

    void work()
    {
      std::unique_lock<std::mutex> lock(mutex_);
      while (true) {
        changed_.wait(lock, [this] {return is_closed_ || !jobs_.empty();});
        if (jobs_.empty()) {
          return;
        }
        auto job = std::move(jobs_.front());
        lock.unlock();
        job();
        job = nullptr;  // What it owns is freed without the lock.
        lock.lock();
        jobs_.pop_front();
        changed_.notify_all();
      }
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    bool is_closed_ = false;
  };

  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();
  std::thread thread_;
};

}  // namespace driving

#endif  // ROS__JOB_THREAD_HPP_
