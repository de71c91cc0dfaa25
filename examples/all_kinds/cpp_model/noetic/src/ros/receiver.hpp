// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__RECEIVER_HPP_
#define ROS__RECEIVER_HPP_

#include <functional>
#include <future>
#include <string>
#include <thread>
#include <utility>

#include "stop.hpp"

namespace all_kinds
{

/// A thread that calls a callback of the logic, so that a blocking callback delays no other.
class Receiver
{
public:
  explicit Receiver(const std::string & name)
  : name_(name)
  {
  }

  Receiver(const Receiver &) = delete;
  Receiver & operator=(const Receiver &) = delete;

  virtual ~Receiver() = default;

  /// Return the name of the topic, service or action.
  const std::string & name() const {return name_;}

  /// Begin no further callback; the current one goes on.
  virtual void stop() = 0;

  /// Wait for the current callback; return whether it has returned by then.
  bool wait_until(Stop::Clock::time_point end) const
  {
    return ended_.wait_until(end) == std::future_status::ready;
  }

  /// Reply to clients on behalf of a callback that does not return in time.
  virtual void abandon() {}

protected:
  /// Start the thread, at the end of the constructor.
  void start(const std::function<void()> & work)
  {
    std::packaged_task<void()> task(
      [this, work] {
        name_this_thread(name_);
        work();
      });
    ended_ = task.get_future();
    thread_ = std::thread(std::move(task));
  }

  /// Join the thread, in the destructor.
  void join()
  {
    stop();
    thread_.join();
  }

private:
  std::string name_;
  std::future<void> ended_;
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // ROS__RECEIVER_HPP_
