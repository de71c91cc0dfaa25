// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ACTION_SERVER_HPP_
#define ROS__ACTION_SERVER_HPP_

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "actionlib/server/action_server.h"
#include "ros/console.h"
#include "ros/node_handle.h"

#include "receiver.hpp"
#include "supervisor.hpp"

#include "all_kinds/ros/goal.hpp"

namespace all_kinds
{

/// What becomes of a goal that comes while others are executed.
struct GoalPolicy
{
  enum Kind {replace, queue, reject, parallel};

  /// At most `at_once` goals run at a time: one, unless the policy is parallel.
  GoalPolicy(Kind kind, std::size_t at_once = 1)  // NOLINT(runtime/explicit)
  : kind(kind),
    at_once(at_once)
  {
  }

  /// Return whether a goal is accepted beside so many others.
  bool accepts_beside(std::size_t others) const
  {
    return kind == replace || kind == queue || others < at_once;
  }

  Kind kind;
  std::size_t at_once;
};

/// Serves an action: executes one goal at a time in a thread of its own, or several in several.
///
/// To be destroyed when ROS takes no more goals: actionlib 1.14 destroys its publishers first.
template<typename Action>
class ActionServer : public Receiver
{
public:
  using Execute = std::function<void (Goal<Action> &)>;
  using Accept = std::function<bool (const typename Action::Goal &)>;

  /// Call `execute` with each goal; `method` is its name in the log.
  ///
  /// Goals that `accept` refuses are rejected; it is called in the thread of the node handle.
  ActionServer(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    GoalPolicy policy,
    Supervisor & supervisor,
    Execute execute,
    Accept accept = nullptr)
  : Receiver(name),
    method_(method),
    policy_(policy),
    supervisor_(supervisor),
    execute_(std::move(execute)),
    accept_(std::move(accept)),
    server_(
      node,
      name,
      [this](Handle handle) {
        take(handle);
      },
      [this](Handle handle) {
        cancel(handle);
      },
      false)
  {
    start(
      [this] {
        std::vector<std::thread> others;
        while (others.size() + 1 < policy_.at_once) {
          others.emplace_back(
            [this] {
              name_this_thread(this->name());
              work();
            });
        }
        work();
        for (auto & other : others) {
          other.join();
        }
      });
    server_.start();
  }

  ~ActionServer() override {join();}

  /// Take no more goals, and abort those that wait.
  void stop() final
  {
    std::deque<Handle> waiting;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopped_ = true;
      waiting.swap(waiting_);
    }
    changed_.notify_all();
    for (auto & handle : waiting) {
      handle.setAborted(Result(), "The node stops.");
    }
  }

  /// Abort the current goals, whose execution does not end.
  void abandon() override
  {
    std::vector<std::shared_ptr<ServedGoal>> goals;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      goals.swap(current_);
    }
    for (const auto & goal : goals) {
      goal->handle.setAborted(Result(), "The node stops.");
    }
  }

private:
  using Server = actionlib::ActionServer<typename Action::Type>;
  using Handle = typename Server::GoalHandle;
  using Result = typename Action::Result;

  class ServedGoal : public Goal<Action>
  {
public:
    ServedGoal(const Handle & handle, const Supervisor & supervisor)
    : Goal<Action>(*handle.getGoal()),
      handle(handle),
      supervisor_(supervisor)
    {
    }

    bool cancel_requested() override {return canceled || supervisor_.stopping();}
    void publish_feedback() override {handle.publishFeedback(this->feedback);}

    Handle handle;
    std::atomic<bool> canceled{false};

private:
    const Supervisor & supervisor_;
  };

  void take(Handle & handle)
  {
    if (is_refused()) {
      handle.setRejected(Result(), "Another goal is executed, or the node stops.");
      return;
    }
    if (accept_ && !(accept_(*handle.getGoal()) && !is_refused())) {
      handle.setRejected(Result(), "The logic refuses the goal, or the node stops.");
      return;
    }
    handle.setAccepted();
    std::deque<Handle> replaced;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (policy_.kind == GoalPolicy::replace) {
        replaced.swap(waiting_);
        for (const auto & goal : current_) {
          goal->canceled = true;
        }
      }
      if (!stopped_) {
        waiting_.push_back(handle);
        handle = Handle();
      }
    }
    changed_.notify_one();
    if (handle.isValid()) {
      handle.setAborted(Result(), "The node stops.");
    }
    for (auto & old : replaced) {
      old.setCanceled(Result(), "A new goal replaces this one.");
    }
  }

  bool is_refused()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stopped_ || !policy_.accepts_beside(current_.size() + waiting_.size());
  }

  void cancel(Handle & handle)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const auto & goal : current_) {
        if (goal->handle == handle) {
          goal->canceled = true;
          return;
        }
      }
      const auto found = std::find(waiting_.begin(), waiting_.end(), handle);
      if (found == waiting_.end()) {
        return;
      }
      waiting_.erase(found);
    }
    handle.setCanceled();
  }

  void work()
  {
    while (const auto goal = next()) {
      const bool returned = supervisor_.guard(method_, [&] {execute_(*goal);});
      if (finish(goal)) {
        report(*goal, returned);
      }
    }
  }

  /// Return the next goal to execute, nothing when the node stops.
  std::shared_ptr<ServedGoal> next()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] {return stopped_ || !waiting_.empty();});
    if (stopped_ || supervisor_.stopping()) {
      return nullptr;
    }
    current_.push_back(std::make_shared<ServedGoal>(waiting_.front(), supervisor_));
    waiting_.pop_front();
    return current_.back();
  }

  /// Return whether the goal has not been abandoned.
  bool finish(const std::shared_ptr<ServedGoal> & goal)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find(current_.begin(), current_.end(), goal);
    const bool is_current = found != current_.end();
    if (is_current) {
      current_.erase(found);
    }
    return is_current;
  }

  void report(ServedGoal & goal, bool returned)
  {
    switch (returned ? goal.outcome() : Outcome::aborted) {
      case Outcome::succeeded:
        goal.handle.setSucceeded(goal.result);
        break;
      case Outcome::canceled:
        if (goal.canceled) {
          goal.handle.setCanceled(goal.result);
        } else {  // the node stops
          goal.handle.setAborted(goal.result);
        }
        break;
      case Outcome::aborted:
        goal.handle.setAborted(goal.result);
        break;
      case Outcome::none:
        if (!goal.cancel_requested()) {
          ROS_WARN("%s returned without an outcome: the goal is aborted.", method_.c_str());
        }
        goal.handle.setAborted(goal.result);
        break;
    }
  }

  std::string method_;
  GoalPolicy policy_;
  Supervisor & supervisor_;
  Execute execute_;
  Accept accept_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Handle> waiting_;
  std::vector<std::shared_ptr<ServedGoal>> current_;
  bool stopped_ = false;
  Server server_;
};

}  // namespace all_kinds

#endif  // ROS__ACTION_SERVER_HPP_
