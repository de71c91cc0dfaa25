// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CALLS_HPP_
#define ROS__CALLS_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "stop.hpp"

namespace all_kinds
{

/// The calls of the logic that are running; thread-safe. Reports exceptions of the logic.
class Calls
{
public:
  using Report = std::function<void (const std::string & failure)>;

  /// Report every failure of the logic.
  explicit Calls(Report report)
  : report_(std::move(report))
  {
  }

  /// Call `on_failure` at the next failure, until it is replaced.
  void watch(const std::function<void()> & on_failure)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    on_failure_ = on_failure;
    failure_ = on_failure ? "" : failure_;
  }

  /// Allow callbacks to call the logic: the node is active.
  void open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = true;
    ++opening_;
  }

  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = false;
  }

  bool is_open() const {return is_open_;}

  using Pass = std::uint64_t;

  /// Return a pass for `run`; it is valid until the next `close`.
  Pass pass()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return opening_;
  }

  /// Call a callback of the logic; return false if the pass is no longer valid, or it throws.
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
    return call(method, callback);
  }

  /// Count a method as running until `call` returns.
  void enter(const std::string & method)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_.push_back(method);
  }

  /// Call a method that counts as running; return false if it has thrown.
  template<typename Body>
  bool call(const std::string & method, const Body & body)
  {
    bool has_returned = false;
    try {
      body();
      has_returned = true;
    } catch (const std::exception & error) {
      fail("The logic failed in " + method + ": " + error.what());
    } catch (...) {
      fail("The logic failed in " + method + ": unknown exception");
    }
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      running_.erase(std::find(running_.begin(), running_.end(), method));
    }
    changed_.notify_all();
    return has_returned;
  }

  /// Count a failure of the logic.
  void fail(const std::string & failure)
  {
    report_(failure);
    ++failures_;
    const std::lock_guard<std::mutex> lock(mutex_);
    failure_ = failure_.empty() ? failure : failure_;
    // With the lock held: `on_failure` is not called any more once it has been replaced.
    if (const auto on_failure = std::exchange(on_failure_, nullptr)) {
      on_failure();
    }
  }

  /// Return how often the logic has failed.
  std::uint64_t failures() const {return failures_;}

  /// Set why a transition was refused, for diagnostics; empty if it was not.
  void set_refusal(const std::string & refusal)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    failure_ = refusal;
  }

  /// Return the first failure since the node was configured, or what the logic has refused last.
  std::string failure()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return failure_;
  }

  /// Wait until nothing is running; return false if that takes too long.
  bool wait_until_none(Stop::Clock::time_point end)
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
  Report report_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> running_;
  std::function<void()> on_failure_;
  std::string failure_;
  std::atomic<bool> is_open_{false};
  Pass opening_ = 0;
  std::atomic<std::uint64_t> failures_{0};
};

/// A thread that runs jobs in their order.
class JobThread
{
public:
  using Job = std::function<void ()>;

  explicit JobThread(const std::string & name)
  : thread_(
      [queue = queue_, name] {
        name_this_thread(name);
        work(*queue);
      })
  {
  }

  JobThread(const JobThread &) = delete;
  JobThread & operator=(const JobThread &) = delete;

  /// Run the jobs that are left, then join the thread.
  ~JobThread()
  {
    if (thread_.joinable()) {
      end_by(Stop::deadline(std::chrono::hours(8760)));
    }
  }

  /// Run the jobs that are left. A thread that is late is detached: its jobs own all they use.
  void end_by(Stop::Clock::time_point end)
  {
    {
      const std::lock_guard<std::mutex> lock(queue_->mutex);
      queue_->is_closed = true;
    }
    queue_->changed.notify_all();
    if (wait_until_idle(end)) {
      thread_.join();
    } else {
      thread_.detach();
    }
  }

  void post(Job job)
  {
    {
      const std::lock_guard<std::mutex> lock(queue_->mutex);
      queue_->jobs.push_back(std::move(job));
    }
    queue_->changed.notify_all();
  }

  /// Wait until no job is running or waiting; return false if that takes too long.
  bool wait_until_idle(Stop::Clock::time_point end)
  {
    std::unique_lock<std::mutex> lock(queue_->mutex);
    return queue_->changed.wait_until(lock, end, [this] {return queue_->jobs.empty();});
  }

private:
  struct Queue
  {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Job> jobs;
    bool is_closed = false;
  };

  static void work(Queue & queue)
  {
    std::unique_lock<std::mutex> lock(queue.mutex);
    while (true) {
      queue.changed.wait(lock, [&queue] {return queue.is_closed || !queue.jobs.empty();});
      if (queue.jobs.empty()) {
        return;
      }
      auto job = std::move(queue.jobs.front());
      lock.unlock();
      job();
      job = nullptr;  // What it owns is freed without the lock.
      lock.lock();
      queue.jobs.pop_front();
      queue.changed.notify_all();
    }
  }

  std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // ROS__CALLS_HPP_
