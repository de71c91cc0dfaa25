// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__MANAGED_NODE_HPP_
#define ROS__MANAGED_NODE_HPP_

#include <semaphore.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lifecycle_msgs/msg/state.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "callback_thread.hpp"
#include "calls.hpp"
#include "deadline.hpp"
#include "stop.hpp"
#include "timing.hpp"
#include "all_kinds/ros/logger.hpp"

namespace all_kinds
{

class ManagedNode;

/// The logic of a node from configure to cleanup, with all it uses.
///
/// Its threads share it: one that does not end in time keeps it after the node is gone.
class Session
{
public:
  virtual ~Session() = default;

  // In the thread of the logic
  virtual bool configure() = 0;
  virtual bool activate() = 0;
  virtual void work() {}  // the cycles, until the node stops
  virtual void deactivate() = 0;
  virtual void cleanup() = 0;

  // In the thread of a transition
  /// Create subscriptions and servers.
  virtual void connect(ManagedNode & node) = 0;

  /// Ask goals that are executed to end.
  virtual void stop() {}

  /// Destroy subscriptions and service servers; give every goal a result.
  virtual void disconnect() {}

  /// Cancel the goals that the logic has sent; wait for that until `end`.
  virtual void cancel_goals(Stop::Clock::time_point /* end */) {}

  /// Wait until the last messages and results have been received, at most until `end`.
  virtual void flush(Stop::Clock::time_point /* end */) {}
};

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
    checked_ = add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> & parameters) {return check(parameters);});
    try {
      declare_own_parameters();
    } catch (const std::exception &) {
      end();  // A LifecycleNode that is not finalized logs a warning.
      throw;
    }
    // Communication still works in this callback.
    pre_shutdown_ = context_->add_pre_shutdown_callback([this] {end();});
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0), [this] {
          start_timer_->cancel();
          life_cycle_.post([this] {start();});
        });
    }
  }

  /// Deactivate, clean up and finalize, as when a component is unloaded.
  ~ManagedNode() override
  {
    context_->remove_pre_shutdown_callback(pre_shutdown_);
    end();
    logic_.end_by(Stop::deadline(timeouts::RETURN));
    changes_.end_by(Stop::deadline(timeouts::RETURN));
    for (const auto & [name, thread] : beside_) {
      thread->end_by(Stop::deadline(timeouts::RETURN));
    }
  }

  /// The node has the process for itself: a failure shuts the context down.
  void be_alone() {is_alone_ = true;}

  /// Return whether the node failed, or could not stop.
  bool has_failed() const {return has_failed_ || calls_->failures() > 0;}

  /// Return whether threads of the logic do not end.
  bool is_stuck() {return !calls_->names().empty();}

  const std::shared_ptr<Stop> & stop() const {return stop_;}
  const std::shared_ptr<Calls> & calls() const {return calls_;}

  /// Return when missing servers may be reported again, in whichever activation.
  const std::shared_ptr<Stop::Clock::time_point> & missing_due() const {return missing_due_;}

  /// Run a method in a thread of its own, the same in every activation, until the node stops.
  void run_beside(const std::string & name, const std::function<void()> & method)
  {
    auto & thread = beside_[name];
    if (!thread) {
      thread = std::make_unique<JobThread>(name);
    }
    calls_->enter(name);
    thread->post([calls = calls_, name, method] {calls->call(name, method);});
  }

  /// Call a method again and again, in a thread of its own, until the node stops.
  void repeat(const std::string & name, const std::function<void()> & method)
  {
    run_beside(
      name, [calls = calls_, stop = stop_, method] {
        while (calls->is_open() && !stop->requested()) {
          method();
        }
      });
  }

  /// Call a method whenever a topic becomes late, in a thread of its own, until the node stops.
  void watch(
    const std::shared_ptr<Deadline> & deadline,
    const std::string & name,
    const std::function<void()> & method,
    const std::string & topic = "")
  {
    run_beside(
      name, [deadline, calls = calls_, method, topic] {
        deadline->watch([calls] {return calls->is_open();}, method, topic);
      });
  }

  /// Call a method at a frequency, in a thread of its own, until the node stops.
  void call_at(
    double frequency, const std::string & name, const std::function<void()> & method)
  {
    auto & timer = timers_[name];
    if (!timer) {
      const Sleeper sleeper(get_clock(), stop_);
      timer = std::make_shared<Loop>(sleeper, frequency, get_logger(), name);
    }
    run_beside(
      name, [timer, calls = calls_, method] {
        timer->run([&] {method(); return calls->is_open();});
      });
  }

  /// Return a callback group that is spun by a thread of its own, named after what it serves.
  rclcpp::CallbackGroup::SharedPtr callback_group(
    const std::string & kind, const std::string & name)
  {
    // Reused by later activations: rclcpp 29.3 (NodeBase) never forgets a callback group.
    auto & thread = callback_threads_[kind + " " + name];
    if (!thread) {
      thread = std::make_unique<CallbackThread>(*this, name);
    }
    return thread->group();
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    if (!may_start("configure") || !has_topics()) {
      return CallbackReturn::FAILURE;
    }
    known_failures_ = calls_->failures();
    calls_->watch([this] {fail();});
    session_ = make_session();
    const auto result = start_logic(
      "configure", &Session::configure, "cleanup", &Session::cleanup);
    is_configured_ = result == CallbackReturn::SUCCESS;
    if (result == CallbackReturn::FAILURE) {
      clean_up();
    }
    return has_thrown() ? CallbackReturn::ERROR : result;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
  {
    if (!may_start("activate")) {
      return CallbackReturn::FAILURE;
    }
    if (!has_thrown()) {
      calls_->set_refusal("");
    }
    const auto result = start_logic(
      "activate", &Session::activate, "deactivate", &Session::deactivate);
    is_activated_ = result == CallbackReturn::SUCCESS;
    if (is_activated_ && !is_ending_ && !has_thrown()) {
      calls_->open();
      session_->connect(*this);
      post("update", [session = session_] {session->work(); return true;});
    }
    return has_thrown() ? CallbackReturn::ERROR : result;
  }

  CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override
  {
    deactivate_logic();
    return has_thrown() ? CallbackReturn::ERROR : CallbackReturn::SUCCESS;
  }

  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    clean_up();
    wake_threads();
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
    report();  // at once, as the process may end soon
    deactivate_logic();
    clean_up();
    known_failures_ = calls_->failures();
    fail();
    return CallbackReturn::SUCCESS;
  }

protected:
  /// Create the logic with its publishers and clients.
  virtual std::shared_ptr<Session> make_session() = 0;

  /// Publish how the node is, if it has diagnostics.
  virtual void report() {}

  /// Stop, whatever the state; a derived class does so before its members are destroyed.
  void end()
  {
    is_ending_ = true;
    stop_->request(false);
    const std::lock_guard<std::mutex> lock(transition_mutex_);
    while (state() != State::PRIMARY_STATE_FINALIZED) {
      settle();
      shutdown();  // It fails if a transition has begun in another thread: tried again.
      if (!context_->is_valid()) {
        break;
      }
    }
    // Joined one by one: several threads at once may not destroy entities of rclcpp 29.3.
    callback_threads_.clear();
    if (is_stuck()) {
      has_failed_ = true;
    }
  }

  template<typename Value>
  void declare(
    const std::string & name,
    const Value & value,
    const rcl_interfaces::msg::ParameterDescriptor & descriptor)
  {
    if (!descriptor.floating_point_range.empty()) {
      ranged_.insert(name);
    }
    declare_parameter(name, value, descriptor);
  }

  /// Declare how often update runs, in Hz; return what is given when the node starts.
  double declare_frequency(double frequency)
  {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = "How often update runs, Hz";
    descriptor.read_only = true;
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = 0.001;
    descriptor.floating_point_range[0].to_value = 100000.0;
    declare("frequency", frequency, descriptor);
    return get_parameter("frequency").as_double();
  }

  /// Call reconfigure in a thread of its own; return why the logic refuses, or "".
  std::string call_reconfigure(const std::function<std::string()> & reconfigure)
  {
    const auto reason = std::make_shared<std::promise<std::string>>();
    auto answer = reason->get_future();
    calls_->enter("reconfigure");
    changes_.post(
      [calls = calls_, reconfigure, reason] {
        std::string refusal = "reconfigure has failed";
        calls->call("reconfigure", [&] {refusal = reconfigure();});
        reason->set_value(refusal);
      });
    const bool has_returned =
      answer.wait_for(timeouts::RECONFIGURE) == std::future_status::ready;
    return has_returned ? answer.get() : "reconfigure has not returned";
  }

  /// Refuse NaN and infinity, as rclcpp 29.3 does not; and changes of what is fixed.
  rcl_interfaces::msg::SetParametersResult check(
    const std::vector<rclcpp::Parameter> & parameters)
  {
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = true;
    for (const auto & parameter : parameters) {
      const auto & name = parameter.get_name();
      const bool is_double = parameter.get_type() == rclcpp::PARAMETER_DOUBLE;
      if (is_double && ranged_.count(name) > 0 && !std::isfinite(parameter.as_double())) {
        result.successful = false;
        result.reason = name + " must be a finite number.";
      }
      if (fixed_.count(name) > 0 && state() != State::PRIMARY_STATE_UNCONFIGURED) {
        result.successful = false;
        result.reason = name + " can be changed only while the node is unconfigured.";
      }
    }
    return result;
  }

  /// Parameters that can be changed only while the node is unconfigured.
  std::set<std::string> fixed_;

  /// Parameters that have names of topics.
  std::vector<std::string> topic_parameters_;

private:
  using State = lifecycle_msgs::msg::State;

  std::uint8_t state() {return get_current_state().id();}

  Stop::Seconds stop_timeout() const
  {
    return Stop::Seconds(get_parameter("stop_timeout").as_double());
  }

  void declare_own_parameters()
  {
    rcl_interfaces::msg::ParameterDescriptor autostart;
    autostart.description = "Whether the node configures and activates itself.";
    autostart.read_only = true;
    declare_parameter("autostart", true, autostart);
    rcl_interfaces::msg::ParameterDescriptor stop_timeout;
    stop_timeout.description = "Time that the logic has to return when the node stops, s";
    stop_timeout.floating_point_range.resize(1);
    stop_timeout.floating_point_range[0].to_value = 3600.0;
    declare("stop_timeout", 2.0, stop_timeout);
  }

  /// Wait for a transition that is under way in another thread.
  void settle()
  {
    while (state() >= State::TRANSITION_STATE_CONFIGURING && context_->is_valid()) {
      std::this_thread::sleep_for(timeouts::SETTLE);
    }
  }

  /// Configure and activate the node.
  void start()
  {
    std::unique_lock<std::mutex> lock(transition_mutex_);
    settle();
    if (state() != State::PRIMARY_STATE_UNCONFIGURED || is_ending_) {
      return;
    }
    if (configure().id() == State::PRIMARY_STATE_INACTIVE) {
      activate();
    }
    if (state() != State::PRIMARY_STATE_ACTIVE && !is_ending_) {
      has_failed_ = true;
      lock.unlock();
      end_process();
    }
  }

  /// Deactivate or clean up after a failure, which goes through error processing.
  void recover()
  {
    std::unique_lock<std::mutex> lock(transition_mutex_);
    settle();
    if (has_thrown() && state() == State::PRIMARY_STATE_ACTIVE) {
      deactivate();
    } else if (has_thrown() && state() == State::PRIMARY_STATE_INACTIVE) {
      cleanup();
    }
    lock.unlock();
    end_process();
  }

  /// End the process, if no other node is in it.
  void end_process()
  {
    if (is_alone_) {
      context_->shutdown("the node has failed");
    }
  }

  /// Return whether the logic has thrown, or said that it fails, since it was configured.
  bool has_thrown() const {return calls_->failures() != known_failures_;}

  /// Recover in the thread of transitions: a transition may be waiting for the caller.
  void fail()
  {
    has_failed_ = true;
    life_cycle_.post([this] {recover();});
  }

  /// Return whether the parameters that have names of topics do so.
  bool has_topics()
  {
    for (const auto & name : topic_parameters_) {
      const auto value = get_parameter(name);
      const bool is_list = value.get_type() == rclcpp::PARAMETER_STRING_ARRAY;
      const auto topics = is_list ? value.as_string_array() : std::vector{value.as_string()};
      const std::string wanted =
        is_list ? "have names of topics, each once" : "be the name of a topic";
      std::set<std::string> known;
      for (const auto & topic : topics) {
        std::string found = known.insert(topic).second ? "" : "'" + topic + "' twice";
        try {
          get_node_topics_interface()->resolve_topic_name(topic);
        } catch (const std::exception &) {
          found = "'" + topic + "'";
        }
        if (!found.empty()) {
          return refuse("Parameter " + name + " must " + wanted + ", not " + found + ".");
        }
      }
    }
    return true;
  }

  /// Say why a transition fails; return false.
  bool refuse(const std::string & reason)
  {
    calls_->set_refusal(reason);
    RCLCPP_ERROR(get_logger(), "%s", reason.c_str());
    return false;
  }

  /// Return whether the thread of the logic is free for a method.
  bool may_start(const std::string & method)
  {
    const auto names = calls_->names();
    if (!names.empty()) {
      return refuse("Cannot " + method + ": " + names + " has not returned.");
    }
    stop_->clear();
    if (is_ending_) {
      stop_->request();
    }
    return !is_ending_;
  }

  /// Run a method in the thread of the logic; give what it returns, or an error if it throws.
  std::shared_future<CallbackReturn> post(
    const std::string & method, const std::function<bool()> & body)
  {
    calls_->enter(method);
    const auto job = std::make_shared<std::packaged_task<CallbackReturn()>>(
      [calls = calls_, method, body] {
        auto result = CallbackReturn::ERROR;
        calls->call(
          method, [&] {
            result = body() ? CallbackReturn::SUCCESS : CallbackReturn::FAILURE;
          });
        return result;
      });
    logic_.post(
      [job, stop = stop_] {
        (*job)();
        stop->change([] {});
      });
    return job->get_future().share();
  }

  void report_running() const
  {
    RCLCPP_ERROR(
      get_logger(), "Still running when the node stops: %s.", calls_->names().c_str());
  }

  /// Run configure or activate, which may take any time unless the node is told to stop.
  ///
  /// If it returns only after that, what it did is undone: deactivate or cleanup is called.
  CallbackReturn start_logic(
    const std::string & method,
    bool (Session::* start)(),
    const std::string & undoing_method,
    void (Session::* undo)())
  {
    const auto end = post(
      method, [session = session_, start] {
        return (session.get()->*start)();
      });
    const auto is_ready = [&] {
        return end.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      };
    stop_->wait(is_ready, [] {return std::chrono::hours(1);});
    if (end.wait_for(stop_timeout()) != std::future_status::ready) {
      report_running();
      post(
        undoing_method, [session = session_, undo, end] {
          if (end.get() == CallbackReturn::SUCCESS) {
            (session.get()->*undo)();
          }
          return true;
        });
      return CallbackReturn::FAILURE;
    }
    if (end.get() == CallbackReturn::FAILURE && !is_ending_) {
      refuse("The logic refused to " + method + ".");
    }
    return end.get();
  }

  /// Run deactivate or cleanup, which may take `stop_timeout`.
  void end_logic(const std::string & method, void (Session::* method_of_session)())
  {
    const bool is_free = logic_.wait_until_idle(Stop::deadline(timeouts::RETURN));
    if (is_free) {  // else the waits of a late method would go on
      stop_->clear(true);
    }
    const auto end = post(
      method, [session = session_, method_of_session] {
        (session.get()->*method_of_session)();
        return true;
      });
    if (!is_free || end.wait_for(stop_timeout()) != std::future_status::ready) {
      stop_->request();
      if (end.wait_for(timeouts::RETURN) != std::future_status::ready) {
        report_running();
      }
    }
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
    wake_threads();
    end_logic("deactivate", &Session::deactivate);
    session_->cancel_goals(Stop::deadline(stop_timeout()));
  }

  /// Let executors that wait drop what is destroyed.
  void wake_threads()
  {
    for (const auto & [name, thread] : callback_threads_) {
      thread->wake();
    }
  }

  /// Clean the logic up and drop it.
  void clean_up()
  {
    calls_->watch(nullptr);
    if (!session_) {
      return;
    }
    if (std::exchange(is_configured_, false)) {
      end_logic("cleanup", &Session::cleanup);
    }
    session_->cancel_goals(Stop::deadline(stop_timeout()));
    session_->flush(Stop::deadline(timeouts::RECEIVE));
    session_.reset();
  }

  rclcpp::Context::SharedPtr context_;
  rclcpp::PreShutdownCallbackHandle pre_shutdown_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  std::shared_ptr<void> checked_;
  std::set<std::string> ranged_;  // parameters
  std::shared_ptr<Stop> stop_ = std::make_shared<Stop>();
  std::shared_ptr<Calls> calls_ = std::make_shared<Calls>(
    [logger = get_logger()](const std::string & failure) {
      RCLCPP_ERROR(logger, "%s", failure.c_str());
    });
  std::map<std::string, std::unique_ptr<CallbackThread>> callback_threads_;
  std::shared_ptr<Stop::Clock::time_point> missing_due_ =
    std::make_shared<Stop::Clock::time_point>();
  std::shared_ptr<Session> session_;
  bool is_configured_ = false;
  bool is_activated_ = false;
  std::atomic<std::uint64_t> known_failures_{0};
  std::atomic<bool> has_failed_{false};
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_alone_{false};
  std::mutex transition_mutex_;
  std::map<std::string, std::shared_ptr<Loop>> timers_;
  std::map<std::string, std::unique_ptr<JobThread>> beside_;
  JobThread logic_{"logic"};
  JobThread life_cycle_{"life_cycle"};
  JobThread changes_{"reconfigure"};
};

/// Return a logger that writes to the node's log, with the place of each line.
inline Logger make_logger(const rclcpp::Logger & logger)
{
  return Logger(
    [logger](Logger::Level level, const std::string & text, const Logger::Place & place) {
      constexpr RCUTILS_LOG_SEVERITY severities[] = {
        RCUTILS_LOG_SEVERITY_DEBUG,
        RCUTILS_LOG_SEVERITY_INFO,
        RCUTILS_LOG_SEVERITY_WARN,
        RCUTILS_LOG_SEVERITY_ERROR,
      };
      const rcutils_log_location_t location = {
        place.function, place.file, static_cast<std::size_t>(place.line)};
      const auto severity = severities[static_cast<int>(level)];
      rcutils_log(&location, severity, logger.get_name(), "%s", text.c_str());
    });
}

/// Shuts ROS down at the first SIGINT or SIGTERM; a second one ends the process at once.
///
/// The handlers of rclcpp 29.3 write to the log, where a signal may wait for ever for a lock that
/// its own thread holds (ros2/rclcpp#2982).
class StopRequests
{
public:
  StopRequests()
  {
    sem_init(&wake_up(), 0, 0);
    std::signal(SIGINT, handle_signal);
    std::signal(SIGTERM, handle_signal);
  }

  StopRequests(const StopRequests &) = delete;
  StopRequests & operator=(const StopRequests &) = delete;

  ~StopRequests()
  {
    ended_ = true;
    sem_post(&wake_up());
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  /// Handle signals from now on, including those received since the constructor.
  void obey()
  {
    thread_ = std::thread(
      [this] {
        name_this_thread("stop_requests");
        while (sem_wait(&wake_up()) != 0) {
        }
        if (!ended_) {
          rclcpp::shutdown(nullptr, "it has been told to stop");
        }
      });
  }

private:
  /// A semaphore, since a signal handler may do no more than post it.
  static sem_t & wake_up()
  {
    static sem_t semaphore;
    return semaphore;
  }

  static void handle_signal([[maybe_unused]] int signal)
  {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    sem_post(&wake_up());
  }

  std::atomic<bool> ended_{false};
  std::thread thread_;
};

/// Run a node alone in its process until a signal or a failure; return the exit code.
template<typename Node>
int run_node(int argc, char ** argv)
{
  try {
    StopRequests requests;
    rclcpp::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::None);
    auto node = std::make_shared<Node>(rclcpp::NodeOptions());
    node->be_alone();
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node->get_node_base_interface());
    requests.obey();  // Not before: a node that is half made logs errors when ROS shuts down.
    executor.spin();
    executor.remove_node(node->get_node_base_interface());
    if (node->is_stuck()) {
      // A thread that does not end still uses global objects: they must not be destroyed.
      std::fflush(nullptr);
      std::_Exit(EXIT_FAILURE);
    }
    const int code = node->has_failed() ? EXIT_FAILURE : EXIT_SUCCESS;
    std::thread(
      [code] {
        // Fast DDS 3.2 may wait for itself when another participant leaves at the same time.
        std::this_thread::sleep_for(timeouts::END);
        std::fflush(nullptr);
        std::_Exit(code);
      }).detach();
    node.reset();
    rclcpp::shutdown();
    return code;
  } catch (const std::exception & error) {
    RCLCPP_ERROR(rclcpp::get_logger("all_kinds"), "%s", error.what());
    return EXIT_FAILURE;
  }
}

}  // namespace all_kinds

#endif  // ROS__MANAGED_NODE_HPP_
