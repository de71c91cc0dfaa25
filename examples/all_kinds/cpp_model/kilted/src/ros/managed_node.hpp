// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__MANAGED_NODE_HPP_
#define ROS__MANAGED_NODE_HPP_

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lifecycle_msgs/msg/state.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "callback_thread.hpp"
#include "calls.hpp"
#include "job_thread.hpp"
#include "parameters.hpp"
#include "session.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// A managed node that can be stopped in any state: by transition, signal, exception, unloading.
///
/// One thread, `logic`, configures, activates, updates, deactivates and cleans up; a transition
/// waits for it, which is bounded when the node stops.
class ManagedNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters of every node.
  ManagedNode(const std::string & name, const rclcpp::NodeOptions & options)
  : LifecycleNode(name, options),
    context_(get_node_base_interface()->get_context())
  {
    declare_parameter(
      "autostart",
      true,
      read_only("Whether the node configures and activates itself."));
    declare_parameter(
      "stop_timeout",
      2.0,
      between<double>(
        0.0,
        3600.0,
        described("Time that the logic has to return when the node stops, s")));
    // Communication still works in this callback.
    pre_shutdown_ = context_->add_pre_shutdown_callback([this] {end();});
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start_timer_->cancel();
          life_cycle_.post([this] {start();});
        });
    }
  }

  ManagedNode(const ManagedNode &) = delete;
  ManagedNode & operator=(const ManagedNode &) = delete;

  /// Deactivate, clean up and finalize, as when a component is unloaded.
  ~ManagedNode() override
  {
    context_->remove_pre_shutdown_callback(pre_shutdown_);
    end();
    logic_.end_by(Stop::Clock::now() + std::chrono::milliseconds(100));
  }

  /// Shut the context down after a failure, and let a second signal end the process at once.
  void be_alone() {is_alone_ = true;}

  /// Return whether the node failed, or could not stop.
  bool has_failed() const {return has_failed_ || calls_->failures() > 0;}

  /// Return whether threads of the logic do not end.
  bool is_stuck() {return !calls_->names().empty();}

  const std::shared_ptr<Stop> & stop() const {return stop_;}
  const std::shared_ptr<Calls> & calls() const {return calls_;}

  /// Return a callback group that is spun by a thread of its own, named after what it serves.
  rclcpp::CallbackGroup::SharedPtr callback_group(
    const std::string & kind, const std::string & name)
  {
    // Once in the life of the node: it never forgets a callback group.
    auto & thread = callback_threads_[kind + " " + name];
    if (!thread) {
      thread = std::make_unique<CallbackThread>(*this, name);
    }
    return thread->group();
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    if (!may_start("configure")) {
      return CallbackReturn::FAILURE;
    }
    try {
      session_ = make_session();
    } catch (const std::exception & error) {
      RCLCPP_ERROR(get_logger(), "Cannot configure: %s", error.what());
      return CallbackReturn::FAILURE;
    }
    const auto result = start_logic(
      "configure", &Session::configure, "cleanup", &Session::cleanup);
    is_configured_ = result == CallbackReturn::SUCCESS;
    if (result == CallbackReturn::FAILURE) {
      if (!is_ending_) {
        RCLCPP_ERROR(get_logger(), "The logic refused to configure.");
      }
      clean_up();
    }
    return result;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
  {
    if (!may_start("activate")) {
      return CallbackReturn::FAILURE;
    }
    const auto result = start_logic(
      "activate", &Session::activate, "deactivate", &Session::deactivate);
    is_activated_ = result == CallbackReturn::SUCCESS;
    if (result == CallbackReturn::FAILURE && !is_ending_) {
      RCLCPP_ERROR(get_logger(), "The logic refused to activate.");
    }
    if (!is_activated_ || is_ending_) {
      return result;
    }
    calls_->open([this] {fail();});
    session_->connect(*this);
    post("update", [session = session_] {session->work();});
    return result;
  }

  CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override
  {
    deactivate_logic();
    return has_thrown() ? CallbackReturn::ERROR : CallbackReturn::SUCCESS;
  }

  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    clean_up();
    return has_thrown() ? CallbackReturn::ERROR : CallbackReturn::SUCCESS;
  }

  CallbackReturn on_shutdown(const rclcpp_lifecycle::State &) override
  {
    deactivate_logic();
    clean_up();
    return has_thrown() && !is_ending_ ? CallbackReturn::ERROR : CallbackReturn::SUCCESS;
  }

  CallbackReturn on_error(const rclcpp_lifecycle::State &) override
  {
    deactivate_logic();
    clean_up();
    known_failures_ = calls_->failures();
    fail();
    return CallbackReturn::SUCCESS;
  }

protected:
  /// Create the logic with its publishers and clients.
  virtual std::shared_ptr<Session> make_session() = 0;

  /// Stop, whatever the state; a derived class does so before its members are destroyed.
  void end()
  {
    is_ending_ = true;
    if (is_alone_) {  // a second signal ends the process at once
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
    }
    {
      const std::lock_guard<std::mutex> lock(undoing_mutex_);
      if (!is_undoing_) {
        stop_->request();
      }
    }
    const std::lock_guard<std::mutex> lock(transition_mutex_);
    while (state() != State::PRIMARY_STATE_FINALIZED) {
      settle();
      shutdown();  // It does nothing if a transition has begun in another thread.
      if (!context_->is_valid()) {
        break;
      }
    }
    // One after another, as what they drop may not be destroyed by several threads at once.
    callback_threads_.clear();
    if (is_stuck()) {
      has_failed_ = true;
    }
  }

  /// Refuse to change these parameters, unless the node is unconfigured.
  void fix_while_configured(const std::vector<std::string> & names)
  {
    fixed_parameters_ = add_on_set_parameters_callback(
      [this, names](const std::vector<rclcpp::Parameter> & parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = true;
        for (const auto & parameter : parameters) {
          const auto found = std::find(names.begin(), names.end(), parameter.get_name());
          if (found != names.end() && state() != State::PRIMARY_STATE_UNCONFIGURED) {
            result.successful = false;
            result.reason = *found + " can be changed only while the node is unconfigured.";
          }
        }
        return result;
      });
  }

private:
  using State = lifecycle_msgs::msg::State;
  using Body = std::function<void ()>;

  std::uint8_t state() {return get_current_state().id();}

  std::chrono::duration<double> stop_timeout() const
  {
    return std::chrono::duration<double>(get_parameter("stop_timeout").as_double());
  }

  /// Wait for a transition that is under way in another thread.
  void settle()
  {
    while (state() >= State::TRANSITION_STATE_CONFIGURING && context_->is_valid()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Configure and activate the node.
  void start()
  {
    {
      const std::lock_guard<std::mutex> lock(transition_mutex_);
      settle();
      if (state() != State::PRIMARY_STATE_UNCONFIGURED || is_ending_) {
        return;
      }
      if (configure().id() == State::PRIMARY_STATE_INACTIVE) {
        activate();
      }
      if (state() == State::PRIMARY_STATE_ACTIVE || is_ending_) {
        return;
      }
      has_failed_ = is_alone_.load();
    }
    leave_alone();
  }

  /// Deactivate after an exception, which cleans up.
  void recover()
  {
    {
      const std::lock_guard<std::mutex> lock(transition_mutex_);
      settle();
      if (has_thrown() && state() == State::PRIMARY_STATE_ACTIVE) {
        deactivate();
      }
    }
    leave_alone();
  }

  /// End the process, if it is there for this node.
  void leave_alone()
  {
    if (is_alone_) {
      context_->shutdown("the node has failed");
    }
  }

  /// Return whether the logic has thrown since its last start.
  bool has_thrown() const {return calls_->failures() != known_failures_;}

  /// Leave the transition to a thread of the node, as this one must return first.
  void fail()
  {
    has_failed_ = true;
    life_cycle_.post([this] {recover();});
  }

  /// Return whether the thread of the logic is free for a method.
  bool may_start(const char * method)
  {
    const auto names = calls_->names();
    if (!names.empty()) {
      RCLCPP_ERROR(get_logger(), "Cannot %s: %s has not returned.", method, names.c_str());
      return false;
    }
    known_failures_ = calls_->failures();
    stop_->clear();
    if (is_ending_) {
      stop_->request();
    }
    return !is_ending_;
  }

  /// Run a method in the thread of the logic.
  std::future<bool> post(const std::string & method, const Body & body)
  {
    calls_->enter(method);
    const auto job = std::make_shared<std::packaged_task<bool()>>(
      [calls = calls_, method, body] {
        const bool has_returned = calls->guard(method, body);
        calls->leave(method);
        return has_returned;
      });
    logic_.post(
      [job, stop = stop_] {
        (*job)();
        stop->change([] {});
      });
    return job->get_future();
  }

  void report_running() const
  {
    RCLCPP_ERROR(
      get_logger(), "Still running when the node stops: %s.", calls_->names().c_str());
  }

  /// Run configure or activate, which may take any time unless the node is told to stop.
  ///
  /// One that returns too late is undone.
  CallbackReturn start_logic(
    const std::string & method,
    bool (Session::* start)(),
    const std::string & undoing_method,
    void (Session::* undo)())
  {
    const auto is_accepted = std::make_shared<std::atomic<bool>>(false);
    auto end = post(
      method, [session = session_, start, is_accepted] {
        *is_accepted = (session.get()->*start)();
      });
    const auto is_ready = [&] {
        return end.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      };
    while (!is_ready() && !stop_->requested()) {
      stop_->wait_until(Stop::deadline(std::chrono::hours(24)), is_ready);
    }
    if (end.wait_for(stop_timeout()) != std::future_status::ready) {
      report_running();
      post(
        undoing_method, [session = session_, undo, is_accepted] {
          if (*is_accepted) {
            (session.get()->*undo)();
          }
        });
      return CallbackReturn::FAILURE;
    }
    if (!end.get()) {
      return CallbackReturn::ERROR;
    }
    return *is_accepted ? CallbackReturn::SUCCESS : CallbackReturn::FAILURE;
  }

  /// Run deactivate or cleanup, which may take `stop_timeout`.
  void end_logic(const std::string & method, void (Session::* method_of_session)())
  {
    const bool is_free = logic_.wait_until_idle(Stop::deadline(std::chrono::milliseconds(100)));
    set_undoing(true);
    if (is_free) {  // else what is late might go on
      stop_->clear();
    }
    const auto end = post(
      method, [session = session_, method_of_session] {
        (session.get()->*method_of_session)();
      });
    if (!is_free || end.wait_for(stop_timeout()) != std::future_status::ready) {
      stop_->request();
      if (end.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
        report_running();
      }
    }
    set_undoing(false);
  }

  void set_undoing(bool whether)
  {
    const std::lock_guard<std::mutex> lock(undoing_mutex_);
    is_undoing_ = whether;
  }

  /// Stop all of the logic, then deactivate it.
  void deactivate_logic()
  {
    if (!std::exchange(is_activated_, false)) {
      return;
    }
    calls_->close();
    session_->stop();
    stop_->request();
    if (!calls_->wait_until_none(Stop::deadline(stop_timeout()))) {
      report_running();
    }
    session_->disconnect();
    end_logic("deactivate", &Session::deactivate);
    session_->cancel_goals(Stop::deadline(stop_timeout()));
  }

  /// Clean the logic up and drop it.
  void clean_up()
  {
    if (!session_) {
      return;
    }
    if (std::exchange(is_configured_, false)) {
      end_logic("cleanup", &Session::cleanup);
    }
    session_->cancel_goals(Stop::deadline(stop_timeout()));
    session_->flush(Stop::deadline(std::chrono::milliseconds(500)));
    session_.reset();
  }

  rclcpp::Context::SharedPtr context_;
  rclcpp::PreShutdownCallbackHandle pre_shutdown_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  std::shared_ptr<void> fixed_parameters_;
  std::shared_ptr<Stop> stop_ = std::make_shared<Stop>();
  std::shared_ptr<Calls> calls_ = std::make_shared<Calls>(
    [logger = get_logger()](const std::string & method, const std::string & error) {
      RCLCPP_ERROR(logger, "The logic failed in %s: %s", method.c_str(), error.c_str());
    });
  std::map<std::string, std::unique_ptr<CallbackThread>> callback_threads_;
  std::shared_ptr<Session> session_;
  bool is_configured_ = false;
  bool is_activated_ = false;
  std::atomic<std::uint64_t> known_failures_{0};
  std::atomic<bool> has_failed_{false};
  std::atomic<bool> is_ending_{false};
  std::mutex undoing_mutex_;
  bool is_undoing_ = false;
  std::atomic<bool> is_alone_{false};
  std::mutex transition_mutex_;
  JobThread logic_{"logic"};
  JobThread life_cycle_{"life_cycle"};
};

}  // namespace all_kinds

#endif  // ROS__MANAGED_NODE_HPP_
