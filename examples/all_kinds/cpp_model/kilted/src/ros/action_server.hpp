// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ACTION_SERVER_HPP_
#define ROS__ACTION_SERVER_HPP_

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "rclcpp/logging.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

#include "calls.hpp"
#include "goal_threads.hpp"
#include "managed_node.hpp"
#include "served_goal.hpp"

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

/// The base of action servers, whatever their type.
class ActionServerBase
{
public:
  virtual ~ActionServerBase() = default;

  /// Accept goals.
  virtual void start() = 0;

  /// Reject new goals and ask the current ones to end.
  virtual void stop() = 0;

  /// Abort the goals that have not ended.
  virtual void end() = 0;

  /// Wait until `end` for clients to request the results of the last goals.
  virtual void flush(std::chrono::steady_clock::time_point end) = 0;
};

/// The goals of an action server that have no result yet; thread-safe.
template<typename Action>
class Goals
{
public:
  using Clock = std::chrono::steady_clock;
  using Pointer = std::shared_ptr<ServedGoal<Action>>;

  explicit Goals(GoalPolicy policy)
  : policy_(policy)
  {
  }

  void open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = true;
  }

  /// Reject new goals and ask the others to end.
  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_open_ = false;
    ask_all_to_end();
  }

  /// Return whether another goal would be accepted.
  bool is_open()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_open_ && policy_.accepts_beside(goals_.size());
  }

  void push(const Pointer & goal)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (policy_.kind == GoalPolicy::replace) {
      ask_all_to_end();
    }
    if (!is_open_) {
      goal->ask_to_end();
    }
    goals_.push_back(goal);
  }

  /// Forget a goal that ends, before its client learns of it and sends another.
  void remove(const Pointer & goal)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    goals_.erase(std::remove(goals_.begin(), goals_.end(), goal), goals_.end());
    last_end_ = Clock::now();
  }

  /// Abort all goals that have no result yet.
  void give_up()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto & goal : goals_) {
      goal->give_up();
      last_end_ = Clock::now();
    }
  }

  /// Return when the last goal ended.
  Clock::time_point last_end()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return last_end_;
  }

private:
  void ask_all_to_end()
  {
    for (const auto & goal : goals_) {
      goal->ask_to_end();
    }
  }

  const GoalPolicy policy_;
  std::mutex mutex_;
  std::deque<Pointer> goals_;
  Clock::time_point last_end_;
  bool is_open_ = false;
};

/// Serves an action in threads of its own, one goal at a time or several.
template<typename Action>
class ActionServer : public ActionServerBase
{
public:
  using Execute = std::function<void (Goal<Action> &)>;
  using Accept = std::function<bool (const typename Action::Goal &)>;
  template<typename Logic>
  using AcceptMethod = bool (Logic::*)(const typename Action::Goal &);

  /// Call `method` of the logic with each goal that `accept` accepts.
  template<typename Logic, typename Method>
  ActionServer(
    ManagedNode & node,
    const std::string & name,
    GoalPolicy policy,
    const std::shared_ptr<Logic> & logic,
    Method method,
    AcceptMethod<Logic> accept)
  : ActionServer(
      node, name, policy, logic, method,
      [logic = std::weak_ptr<Logic>(logic), accept, calls = node.calls(),
      label = "action " + name](const auto & request) {
        bool is_accepted = false;
        calls->run(
          calls->pass(), label, [&] {
            const auto owned = logic.lock();
            is_accepted = owned && (owned.get()->*accept)(request);
          });
        return is_accepted;
      })
  {
  }

  /// Call a method of the logic with each goal.
  template<typename Logic, typename Method>
  ActionServer(
    ManagedNode & node,
    const std::string & name,
    GoalPolicy policy,
    const std::shared_ptr<Logic> & logic,
    Method method,
    const Accept & accepts = nullptr)
  : goals_(std::make_shared<Goals<Action>>(policy)),
    worker_(std::make_shared<GoalThreads>(name, policy.kind == GoalPolicy::parallel))
  {
    // A waiting executor of rclcpp 29.3 owns its action servers: they do not own the logic.
    const Execute execute = [logic = std::weak_ptr<Logic>(logic), method](Goal<Action> & goal) {
        if (const auto owned = logic.lock()) {
          (owned.get()->*method)(goal);
        }
      };
    const std::string label = "action " + name;
    typename Server::AcceptedCallback accept =
      [goals = goals_, worker = std::weak_ptr<GoalThreads>(worker_), calls = node.calls(),
        logger = node.get_logger(), label, execute](const auto & handle) {
        const auto goal = std::make_shared<ServedGoal<Action>>(handle);
        goals->push(goal);
        if (const auto thread = worker.lock()) {
          thread->post(
            [goal, goals, calls, pass = calls->pass(), logger, label, execute] {
              work(*goals, goal, *calls, pass, logger, label, execute);
            });
        }
      };
    // rclcpp_action 29.3 adds and removes a jump callback of the clock without locking the clock.
    const auto clock = node.get_clock();
    auto destroy = [clock, accept](Server * server) mutable {
        {
          const std::lock_guard<std::mutex> lock(clock->get_clock_mutex());
          delete server;
        }
        accept = nullptr;  // What it owns is freed without the lock.
      };
    {
      const std::lock_guard<std::mutex> lock(clock->get_clock_mutex());
      server_.reset(
        new Server(
          node.get_node_base_interface(),
          node.get_node_clock_interface(),
          node.get_node_logging_interface(),
          name,
          rcl_action_server_get_default_options(),
          [goals = goals_, accepts](const auto &, const auto & request) {
            using Response = rclcpp_action::GoalResponse;
            const bool is_accepted = goals->is_open() &&
            (!accepts || (accepts(*request) && goals->is_open()));
            return is_accepted ? Response::ACCEPT_AND_EXECUTE : Response::REJECT;
          },
          [](const auto &) {return rclcpp_action::CancelResponse::ACCEPT;},
          accept),
        std::move(destroy));
    }
    // Not by rclcpp_action::create_server: see create_client in ros_action_client.hpp.
    node.get_node_waitables_interface()->add_waitable(server_, node.callback_group("action", name));
  }

  ~ActionServer() override
  {
    stop();
    end();
    worker_->end_by(Stop::deadline(timeouts::RETURN));
  }

  ActionServer(const ActionServer &) = delete;
  ActionServer & operator=(const ActionServer &) = delete;

  void start() override {goals_->open();}
  void stop() override {goals_->close();}
  void end() override {goals_->give_up();}

  void flush(std::chrono::steady_clock::time_point end) override
  {
    // A client asks for the result when it learns that its goal was accepted.
    const auto soon = goals_->last_end() + timeouts::RESULT;
    std::this_thread::sleep_until(std::min(soon, end));
  }

private:
  using Server = rclcpp_action::Server<Action>;

  /// Execute a goal, unless it is unwanted by now, and send its result.
  static void work(
    Goals<Action> & goals,
    const std::shared_ptr<ServedGoal<Action>> & goal,
    Calls & calls,
    Calls::Pass pass,
    const rclcpp::Logger & logger,
    const std::string & label,
    const Execute & execute)
  {
    const bool is_wanted = !goal->cancel_requested();
    const bool has_returned = is_wanted && calls.run(
      pass, label, [&] {
        try {
          execute(*goal);
        } catch (...) {
          goals.remove(goal);
          goal->give_up();
          throw;
        }
        if (goal->outcome() == Outcome::none && !goal->cancel_requested()) {
          RCLCPP_WARN(
            logger, "%s returned without an outcome: the goal is aborted.", label.c_str());
        }
        goals.remove(goal);
        goal->finish();
      });
    if (!has_returned) {
      goals.remove(goal);
      goal->canceled();
      goal->finish();
    }
  }

  std::shared_ptr<Goals<Action>> goals_;
  std::shared_ptr<GoalThreads> worker_;
  std::shared_ptr<Server> server_;
};

}  // namespace all_kinds

#endif  // ROS__ACTION_SERVER_HPP_
