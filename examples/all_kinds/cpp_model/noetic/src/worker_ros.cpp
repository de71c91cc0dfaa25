// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node worker: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in worker_impl.cpp.

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "all_kinds/WorkerDynamicConfig.h"
#include "all_kinds/worker_impl.hpp"
#include "all_kinds/worker_interface.hpp"
#include "dynamic_reconfigure/server.h"
#include "ros/action_server.hpp"
#include "ros/callback_thread.hpp"
#include "ros/deadline.hpp"
#include "ros/diagnostics.hpp"
#include "ros/inbox.hpp"
#include "ros/parameters.hpp"
#include "ros/process.hpp"
#include "ros/receiver.hpp"
#include "ros/repeater.hpp"
#include "ros/ros.h"
#include "ros/ros_action_client.hpp"
#include "ros/ros_log.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/ros_service_client.hpp"
#include "ros/ros_transforms.hpp"
#include "ros/supervisor.hpp"
#include "ros/synchronizer.hpp"
#include "ros/timing.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 20.0;  // Hz

/// The node and its life: configure, activate, update until it stops, deactivate, cleanup.
class WorkerNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit WorkerNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  WorkerNode(const WorkerNode &) = delete;
  WorkerNode & operator=(const WorkerNode &) = delete;

  ~WorkerNode()
  {
    spinner_.stop();
  }

  /// Go through the lifecycle, in the thread of the logic.
  void live()
  {
    if (!supervisor_.step("configure", [this] {return impl_->configure(*current_config());})) {
      supervisor_.refuse("The logic refused to configure.");
      diagnostics_->publish();  // at once, as the process ends soon
      return;
    }
    is_configured_ = true;
    supervisor_.set_state("inactive");
    const auto activate = [this] {return impl_->activate();};
    if (!supervisor_.stopping() && supervisor_.step("activate", activate)) {
      supervisor_.set_state("active");
      work();
      supervisor_.set_state("deactivating");
      supervisor_.waits().clear();
      supervisor_.step("deactivate", [this] {impl_->deactivate(); return true;});
    } else {
      supervisor_.refuse("The logic refused to activate.");
    }
    action_delegate_->cancel();
    supervisor_.set_state("cleaning up");
    diagnostics_->publish();  // at once, as the process ends soon
    is_configured_ = false;
    supervisor_.waits().clear();
    supervisor_.step("cleanup", [this] {impl_->cleanup(); return true;});
  }

  /// Abort the goals whose execution does not end.
  void abort_goals()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
      receiver->abandon();
    }
  }

private:
  /// Return how often update runs, in Hz.
  double read_frequency() const
  {
    double frequency = FREQUENCY;
    read_parameter(private_, "frequency", frequency);
    check_range("frequency", frequency, 0.001, 100000.0);
    return frequency;
  }

  void read_parameters()
  {
    double stop_timeout = 2.0;
    read_parameter(private_, "stop_timeout", stop_timeout);
    supervisor_.set_stop_timeout(stop_timeout);
    WorkerConfig config;
    read_parameter(private_, "prefix", config.prefix);
    read_parameter(private_, "echo_topic", config.echo_topic);
    check_topic("echo_topic", config.echo_topic);
    read_parameter(private_, "call_topics", config.call_topics);
    check_topics("call_topics", config.call_topics);
    read_parameter(private_, "answer_topics", config.answer_topics);
    check_topics("answer_topics", config.answer_topics);
    read_parameter(private_, "weights", config.weights);
    read_parameter(private_, "gain", config.gain);
    read_parameter(private_, "step", config.step);
    read_parameter(private_, "verbose", config.verbose);
    read_parameter(private_, "label", config.label);
    config_ = std::make_shared<WorkerConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    WorkerPassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    passthrough.fail = [this](const std::string & reason) {
        supervisor_.fail("The logic failed: " + reason);
      };
    out_counter_ = node_.advertise<worker_types::OutCounter>(
      "counter",
      10);
    out_status_ = node_.advertise<worker_types::OutStatus>(
      "/status",
      10);
    passthrough.pub_echo = advertise<worker_types::PubEcho>(
      node_,
      ros::names::resolve(config_->echo_topic, false),
      10);
    passthrough.pub_empty = advertise<worker_types::PubEmpty>(
      private_,
      "empty",
      10);
    for (const auto & topic : config_->answer_topics) {
      passthrough.pub_answer[topic] = advertise<worker_types::PubAnswer>(
        node_,
        ros::names::resolve(topic, false),
        10);
    }
    passthrough.client_permit = watch(
      "service permit",
      std::make_shared<RosServiceClient<worker_types::ClientPermit>>(
        "permit",
        supervisor_.waits()));
    action_delegate_ = watch(
      "action delegate",
      std::make_shared<RosActionClient<worker_types::ActionDelegate>>(
        node_,
        "delegate"));
    passthrough.action_delegate = action_delegate_;
    const auto listener = std::make_shared<RosTransformListener>(supervisor_.waits());
    passthrough.listener_frames = listener;
    const auto broadcaster = std::make_shared<RosTransformBroadcaster>();
    passthrough.broadcaster_pose = broadcaster;
    reconfigure_server_ =
      std::make_unique<dynamic_reconfigure::Server<WorkerDynamicConfig>>(private_);
    reconfigure_server_->setCallback(
      [this](auto & values, std::uint32_t) {
        reconfigure(values);
      });
    timer_ = watch_.node().createWallTimer(
      ros::WallDuration(Stop::Seconds(timeouts::MISSING).count()),
      [this](const ros::WallTimerEvent &) {
        report_missing_servers();
      });
    diagnostics_ = std::make_unique<Diagnostics>(
      watch_.node(), supervisor_, &loop_);
    diagnostics_->watch(deadline_speed_);
    diagnostics_->watch(deadline_say_);
    passthrough.diagnostics = diagnostics_->logic();
    impl_ = std::make_unique<WorkerImpl>(passthrough);
  }

  /// Receive and update until the node stops.
  void work()
  {
    if (!supervisor_.stopping()) {
      supervisor_.guard("connect_receivers", [this] {connect_receivers();});
    }
    loop_.run(supervisor_, log_, [this] {update();});
    stop_receivers();
  }

  /// Create subscriptions and servers, and start threads; each callback gets its own thread.
  void connect_receivers()
  {
    subscribe(
      node_,
      "speed",
      in_speed_,
      10,
      ros::TransportHints(),
      &deadline_speed_);
    subscribe(
      node_,
      "counter",
      in_counter_);
    subscribe_direct<worker_types::SayMessage>(
      node_,
      "say",
      "receive_say",
      &WorkerImpl::receive_say,
      10,
      ros::TransportHints(),
      &deadline_say_);
    subscribe_each<worker_types::CallMessage>(
      "call",
      current_config()->call_topics,
      "receive_call",
      &WorkerImpl::receive_call);
    const auto synchronizer_sighting = synchronize<
      worker_types::SightingPoint,
      worker_types::SightingMotion>(
      callback_thread("sighting"),
      [this](const auto & ... messages) {
        supervisor_.guard(
          "receive_sighting", [&] {
            impl_->receive_sighting({messages ...});
          });
      },
      10,
      0.05);
    subscribe_input<0>(
      "point",
      synchronizer_sighting);
    subscribe_input<1>(
      "motion",
      synchronizer_sighting,
      5,
      ros::TransportHints().tcpNoDelay());
    serve<worker_types::ResetService>(
      node_,
      "reset",
      "serve_reset",
      &WorkerImpl::serve_reset);
    serve<worker_types::EnableService>(
      node_,
      "enable",
      "serve_enable",
      &WorkerImpl::serve_enable);
    serve_action<worker_types::ComputeAction>(
      node_,
      "compute",
      "execute_compute",
      GoalPolicy::replace,
      &WorkerImpl::execute_compute,
      &WorkerImpl::accept_compute);
    serve_action<worker_types::MeasureAction>(
      node_,
      "measure",
      "execute_measure",
      GoalPolicy(GoalPolicy::parallel, 3),
      &WorkerImpl::execute_measure);
    run_beside(
      "late_speed",
      [this] {
        deadline_speed_.watch(
          [this] {return !supervisor_.stopping();},
          [this] {impl_->late_speed();},
          "speed");
      });
    run_beside(
      "late_say",
      [this] {
        deadline_say_.watch(
          [this] {return !supervisor_.stopping();},
          [this] {impl_->late_say();},
          "say");
      });
    run_beside(
      "read",
      [this] {
        while (!supervisor_.stopping()) {
          impl_->read();
        }
      });
    run_beside(
      "poll",
      [this] {
        timer_poll_.run(supervisor_, log_, [this] {impl_->poll();});
      });
  }

  /// Wait for the callbacks to return. Subscriptions and servers last as long as the node: it takes
  /// an answer of the master to destroy them.
  void stop_receivers()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
    }
    std::string late;
    for (const auto & receiver : receivers_) {
      if (!receiver->wait_until(supervisor_.deadline())) {
        late += (late.empty() ? "" : ", ") + receiver->name();
        receiver->abandon();
      }
    }
    if (!late.empty()) {
      supervisor_.report_late(late);
      return;
    }
    wait_for_sending();  // the last responses and results
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_speed_updated = in_speed_.take(data_.in_speed);
    data_.in_counter_updated = in_counter_.take(data_.in_counter);
    data_.out_counter_active = true;
    data_.out_counter_subscribers = out_counter_.getNumSubscribers();
    data_.out_status_active = true;
    data_.out_status_subscribers = out_status_.getNumSubscribers();
    const bool returned = supervisor_.step(
      "update", [this] {impl_->update(data_, *current_config()); return true;});
    if (!returned) {
      return;
    }
    if (data_.out_counter_active) {
      out_counter_.publish(data_.out_counter);
    }
    if (data_.out_status_active) {
      out_status_.publish(data_.out_status);
    }
  }

  /// Update the configuration with the changed parameters.
  void reconfigure(WorkerDynamicConfig & values)
  {
    const auto config = std::make_shared<WorkerConfig>(*current_config());
    if (!std::isfinite(values.gain)) {
      values.gain = WorkerConfig().gain;
    }
    config->gain = values.gain;
    config->step = values.step;
    config->verbose = values.verbose;
    config->label = values.label;
    std::string refusal;
    if (is_configured_) {
      refusal = "reconfigure has failed";
      supervisor_.guard("reconfigure", [&] {refusal = impl_->reconfigure(*config);});
    }
    if (!refusal.empty()) {
      ROS_WARN("Parameters refused: %s", refusal.c_str());
      values.gain = current_config()->gain;
      values.step = static_cast<int>(current_config()->step);
      values.verbose = current_config()->verbose;
      values.label = current_config()->label;
      return;
    }
    const std::lock_guard<std::mutex> lock(config_mutex_);
    config_ = config;
  }

  std::shared_ptr<const WorkerConfig> current_config()
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    return config_;
  }

  /// Register a client for the check of missing servers.
  template<typename Client>
  std::shared_ptr<Client> watch(const std::string & name, const std::shared_ptr<Client> & client)
  {
    servers_.emplace_back(name, [client] {return client->is_ready();});
    return client;
  }

  /// Warn about servers that are not available.
  void report_missing_servers()
  {
    std::string missing;
    for (const auto & [name, is_ready] : servers_) {
      if (!is_ready()) {
        missing += (missing.empty() ? "" : ", ") + name;
      }
    }
    if (!missing.empty()) {
      log_.warning_throttle(Stop::Seconds(timeouts::QUIET).count(), "Waiting for " + missing + ".");
    }
  }

  template<typename Message>
  std::shared_ptr<Publisher<Message>> advertise(
    ros::NodeHandle & node,
    const std::string & topic,
    std::uint32_t queue_size,
    bool latch = false)
  {
    return std::make_shared<RosPublisher<Message>>(
      node.advertise<Message>(topic, queue_size, latch));
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ros::NodeHandle & node,
    const std::string & topic,
    const Inbox<Message> & inbox,
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints(),
    Deadline * deadline = nullptr)
  {
    subscribers_.push_back(
      node.subscribe<Message, const boost::shared_ptr<Message> &>(
        topic,
        queue_size,
        [inbox, deadline](const boost::shared_ptr<Message> & message) {
          if (deadline) {
            deadline->heard();
          }
          inbox.put(message);
        },
        ros::VoidConstPtr(),
        hints));
  }

  /// Return the node handle of a thread of its own for callbacks.
  ros::NodeHandle & callback_thread(const std::string & name)
  {
    const auto thread = std::make_shared<CallbackThread>(node_, name);
    receivers_.push_back(thread);
    return thread->node();
  }

  /// Subscribe to a topic whose messages are joined with those of others.
  template<std::size_t Input, typename Joined>
  void subscribe_input(
    const std::string & topic,
    const std::shared_ptr<Joined> & synchronizer,
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints())
  {
    using Message = typename Joined::template Message<Input>;
    subscribers_.push_back(
      synchronizer->node().template subscribe<Message>(
        topic,
        queue_size,
        [synchronizer](const boost::shared_ptr<const Message> & message) {
          synchronizer->template add<Input>(message);
        },
        ros::VoidConstPtr(),
        hints));
  }

  /// Subscribe to a topic whose messages go directly to a callback of the logic.
  template<typename Message>
  void subscribe_direct(
    const ros::NodeHandle & node,
    const std::string & topic,
    const std::string & method,
    void (WorkerImpl::* receive)(const Message &),
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints(),
    Deadline * deadline = nullptr)
  {
    const auto thread = std::make_shared<CallbackThread>(node, topic);
    receivers_.push_back(thread);
    subscribers_.push_back(
      thread->node().subscribe<Message>(
        topic,
        queue_size,
        [this, method, receive, deadline](const boost::shared_ptr<const Message> & message) {
          supervisor_.guard(
            method, [&] {
              const auto handle = [&] {(impl_.get()->*receive)(*message);};
              deadline ? deadline->handle(handle) : handle();
            });
        },
        ros::VoidConstPtr(),
        hints));
  }

  /// Subscribe to topics whose messages go directly to a callback of the logic, all in one thread.
  template<typename Message>
  void subscribe_each(
    const std::string & name,
    const std::vector<std::string> & topics,
    const std::string & method,
    void (WorkerImpl::* receive)(
      const std::string &,
      const Message &),
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints())
  {
    const auto thread = std::make_shared<CallbackThread>(node_, name);
    receivers_.push_back(thread);
    for (const auto & topic : topics) {
      subscribers_.push_back(
        thread->node().subscribe<Message>(
          ros::names::resolve(topic, false),
          queue_size,
          [this, topic, method, receive](const boost::shared_ptr<const Message> & message) {
            supervisor_.guard(
              method, [&] {
                (impl_.get()->*receive)(topic, *message);
              });
          },
          ros::VoidConstPtr(),
          hints));
    }
  }

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    void (WorkerImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    const auto thread = std::make_shared<CallbackThread>(node, name);
    receivers_.push_back(thread);
    services_.push_back(
      thread->node().advertiseService<Request, Response>(
        name,
        [this, method, answer](auto & request, auto & response) {
          return supervisor_.guard(
            method, [&] {
              (impl_.get()->*answer)(request, response);
            });
        }));
  }

  /// Create an action server.
  template<typename Action>
  void serve_action(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    GoalPolicy policy,
    void (WorkerImpl::* execute)(Goal<Action> &))
  {
    receivers_.push_back(
      std::make_shared<ActionServer<Action>>(
        node,
        name,
        method,
        policy,
        supervisor_,
        [this, execute](auto & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  /// Create an action server whose goals the logic accepts or refuses, in another thread.
  template<typename Action>
  void serve_action(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    GoalPolicy policy,
    void (WorkerImpl::* execute)(Goal<Action> &),
    bool (WorkerImpl::* accept)(
      const typename Action::Goal &))
  {
    const auto thread = std::make_shared<CallbackThread>(node, name);
    receivers_.push_back(
      std::make_shared<ActionServer<Action>>(
        thread->node(),
        name,
        method,
        policy,
        supervisor_,
        [this, execute](auto & goal) {
          (impl_.get()->*execute)(goal);
        },
        [this, accept, name](const auto & request) {
          bool is_accepted = false;
          supervisor_.guard(
            "accept of " + name, [&] {is_accepted = (impl_.get()->*accept)(request);});
          return is_accepted;
        }));
    receivers_.push_back(thread);  // last: the server uses its queue until it is destroyed
  }

  /// Run what the logic does again and again in a thread of its own.
  void run_beside(const std::string & name, const std::function<void()> & work)
  {
    receivers_.push_back(
      std::make_shared<Repeater>(
        name, [this, name, work] {
          supervisor_.guard(name, work);
        }));
  }

  Supervisor & supervisor_;
  Logger log_{write_log};
  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  Clock clock_{node_, supervisor_.waits()};
  std::shared_ptr<const WorkerConfig> config_;
  std::atomic<bool> is_configured_{false};
  std::mutex config_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<WorkerDynamicConfig>> reconfigure_server_;
  Loop loop_{clock_, read_frequency()};
  WorkerData data_;
  Deadline deadline_speed_{clock_, 0.5};
  Deadline deadline_say_{clock_, 1.0};
  Loop timer_poll_{clock_, 4.0, "poll"};
  Inbox<worker_types::InSpeed> in_speed_;
  Inbox<worker_types::InCounter> in_counter_;
  ros::Publisher out_counter_;
  ros::Publisher out_status_;
  std::shared_ptr<ActionClient<worker_types::ActionDelegate>> action_delegate_;
  std::vector<std::pair<std::string, std::function<bool()>>> servers_;
  std::unique_ptr<WorkerImpl> impl_;
  std::vector<std::shared_ptr<Receiver>> receivers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  CallbackThread watch_{node_, "watch"};
  ros::WallTimer timer_;
  std::unique_ptr<Diagnostics> diagnostics_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  return all_kinds::run_node<all_kinds::WorkerNode>(argc, argv, "worker");
}
