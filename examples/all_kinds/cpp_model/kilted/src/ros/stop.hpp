// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__STOP_HPP_
#define ROS__STOP_HPP_

#ifdef __linux__
#include <pthread.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

namespace all_kinds
{

/// The times that a node allows, besides those of its parameters and of the logic's arguments.
namespace timeouts
{

using std::chrono::milliseconds;

constexpr milliseconds RETURN{100};  // for a method to return, once its waits have been ended
constexpr milliseconds RECONFIGURE{2000};  // for reconfigure to return: the executor waits for it
// For others to receive what was sent last; Fast DDS 3.2 may take 3 s to acknowledge it.
constexpr milliseconds RECEIVE{500};
constexpr milliseconds END{5000};  // for the middleware to leave the graph
constexpr milliseconds SETTLE{1};  // between checks whether a transition or a callback has ended
constexpr milliseconds CALLBACK{1000};  // for a thread of callbacks to end
constexpr milliseconds QUIET{10000};  // between two warnings of the same kind
constexpr milliseconds LATE{5000};  // for which a late cycle makes the status a warning
constexpr milliseconds POLL{10};  // between two checks for a server or a transform
constexpr milliseconds MISSING{2000};  // between two checks for missing servers
constexpr milliseconds WATCH{500};  // between two checks for the server of a goal
constexpr milliseconds LOST{2000};  // until a goal whose server is gone is lost
constexpr milliseconds RESULT{200};  // for a client to ask for the result of its goal

}  // namespace timeouts

/// Name the calling thread for `top -H` and debuggers, with the 15 characters that Linux keeps.
inline void name_this_thread([[maybe_unused]] const std::string & name)
{
#ifdef __linux__
  pthread_setname_np(pthread_self(), name.substr(0, 15).c_str());
#endif
}

/// Ends every wait of the logic when the node stops; thread-safe.
class Stop
{
public:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  /// Return when a timeout of wall time ends; longer ones are cut to a year.
  static Clock::time_point deadline(Seconds timeout)
  {
    const Seconds bounded = std::clamp(timeout, Seconds(0.0), Seconds(std::chrono::hours(8760)));
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(bounded);
  }

  /// End all waits, and at once those that begin before `clear`.
  ///
  /// Waits in `deactivate` and `cleanup`, after `clear(true)`, end only if `also_last`.
  void request(bool also_last = true)
  {
    change(
      [&] {
        if (also_last || !is_last_) {
          requested_ = true;
          ++requests_;
        }
      });
  }

  /// Withdraw the request: waits that begin from now on work again.
  void clear(bool is_last = false)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requested_ = false;
    is_last_ = is_last;
  }

  bool requested() const {return requested_;}

  /// Wait until a condition holds; return false when no time is left, or when the node stops.
  template<typename Condition, typename TimeLeft>
  bool wait(const Condition & condition, const TimeLeft & time_left)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto requests = requests_;
    while (!requested_ && requests == requests_) {
      if (condition()) {
        return true;
      }
      const auto left = time_left();
      if (left <= left.zero()) {
        return false;
      }
      changed_.wait_for(lock, left);
    }
    return false;
  }

  /// The same, until a point in time.
  template<typename Condition>
  bool wait_until(Clock::time_point end, const Condition & condition)
  {
    return wait(condition, [end] {return end - Clock::now();});
  }

  /// The same for a condition that nothing notifies about: it is polled.
  template<typename Condition>
  bool poll_until(Clock::time_point end, const Condition & condition)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto requests = requests_;
    while (true) {
      lock.unlock();
      if (condition()) {
        return true;
      }
      lock.lock();
      if (requested_ || requests != requests_ || Clock::now() >= end) {
        return false;
      }
      changed_.wait_until(lock, std::min(end, Clock::now() + timeouts::POLL));
    }
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
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> requested_{false};
  bool is_last_ = false;
  std::uint64_t requests_ = 0;
};

}  // namespace all_kinds

#endif  // ROS__STOP_HPP_
