// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node worker: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in worker_impl.cpp.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "all_kinds/worker_impl.hpp"
#include "all_kinds/worker_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/deadline.hpp"
#include "ros/diagnostics.hpp"
#include "ros/inbox.hpp"
#include "ros/managed_node.hpp"
#include "ros/missing_servers.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_action_client.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/ros_service_client.hpp"
#include "ros/ros_transforms.hpp"
#include "ros/service_server.hpp"
#include "ros/stop.hpp"
#include "ros/synchronizer.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 20.0;  // Hz

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Publishers and clients exist as long as it does. Subscriptions and service servers exist while
/// it is active. Action servers exist from its first activation on; while inactive, they reject
/// goals.
class WorkerSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const WorkerConfig>>;

  /// Create publishers and clients, then the logic.
  WorkerSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<Loop> & loop,
    const std::shared_ptr<LogicStatus> & status)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    loop_(loop)
  {
    WorkerPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    passthrough.diagnostics = status;
    out_counter_ = topics_.advertise<worker_types::OutCounter>(
      node,
      "counter",
      rclcpp::QoS(10).deadline(rclcpp::Duration::from_seconds(0.5)));
    out_status_ = topics_.advertise<worker_types::OutStatus>(
      node,
      "/status",
      rclcpp::QoS(10).lifespan(rclcpp::Duration::from_seconds(2)));
    passthrough.pub_echo =
      std::make_shared<RosPublisher<worker_types::PubEcho>>(
      topics_.advertise<worker_types::PubEcho>(
        node,
        std::atomic_load(config_.get())->echo_topic,
        rclcpp::QoS(10)
        .liveliness(rclcpp::LivelinessPolicy::ManualByTopic)
        .liveliness_lease_duration(rclcpp::Duration::from_seconds(5))));
    passthrough.pub_empty =
      std::make_shared<RosPublisher<worker_types::PubEmpty>>(
      topics_.advertise<worker_types::PubEmpty>(
        node,
        "~/empty"));
    const auto topics_of_answer = std::atomic_load(config_.get())->answer_topics;
    for (const auto & topic : topics_of_answer) {
      passthrough.pub_answer[topic] =
        std::make_shared<RosPublisher<worker_types::PubAnswer>>(
        topics_.advertise<worker_types::PubAnswer>(
          node,
          topic));
    }
    const auto client_permit =
      std::make_shared<RosServiceClient<worker_types::ClientPermit>>(
      node,
      "permit",
      rclcpp::QoS(1));
    servers_.watch("service permit", client_permit);
    passthrough.client_permit = client_permit;
    action_delegate_ =
      std::make_shared<RosActionClient<worker_types::ActionDelegate>>(
      node,
      "delegate");
    servers_.watch("action delegate", action_delegate_);
    passthrough.action_delegate = action_delegate_;
    const auto listener = std::make_shared<RosTransformListener>(node);
    passthrough.listener_frames = listener;
    const auto broadcaster = std::make_shared<RosTransformBroadcaster>(node);
    passthrough.broadcaster_pose = broadcaster;
    impl_ = std::make_shared<WorkerImpl>(passthrough);
  }

  bool configure() override
  {
    is_configured_ = impl_->configure(*std::atomic_load(config_.get()));
    return is_configured_;
  }

  /// Return whether the logic gets changed parameters: from configure to cleanup.
  bool is_configured() const {return is_configured_;}

  std::string reconfigure(const WorkerConfig & config) {return impl_->reconfigure(config);}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override
  {
    is_configured_ = false;
    impl_->cleanup();
  }

  /// Run the update loop until the node stops.
  void work() override {loop_->run([this] {update(); return true;});}

  /// Create subscriptions and servers, and start threads.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    topics_.subscribe(
      node,
      "speed",
      in_speed_,
      rclcpp::QoS(10),
      deadline_speed_);
    topics_.subscribe(
      node,
      "counter",
      in_counter_);
    topics_.subscribe<worker_types::SayMessage>(
      node,
      "say",
      "say",
      impl_,
      &WorkerImpl::receive_say,
      rclcpp::QoS(10),
      deadline_say_);
    topics_.subscribe<worker_types::CallMessage>(
      node,
      "call",
      std::atomic_load(config_.get())->call_topics,
      impl_,
      &WorkerImpl::receive_call);
    const auto synchronizer_sighting = synchronize<
      worker_types::SightingPoint,
      worker_types::SightingMotion>(
      node,
      "sighting",
      impl_,
      &WorkerImpl::receive_sighting,
      10,
      0.05);
    topics_.subscribe_input<0>(
      node,
      "point",
      synchronizer_sighting);
    topics_.subscribe_input<1>(
      node,
      "motion",
      synchronizer_sighting,
      rclcpp::SensorDataQoS());
    service_servers_.push_back(
      create_service_server<worker_types::ResetService>(
        node,
        "reset",
        impl_,
        &WorkerImpl::serve_reset));
    service_servers_.push_back(
      create_service_server<worker_types::EnableService>(
        node,
        "enable",
        impl_,
        &WorkerImpl::serve_enable,
        rclcpp::QoS(20).best_effort()));
    if (action_servers_.empty()) {
      action_servers_.push_back(
        std::make_unique<ActionServer<worker_types::ComputeAction>>(
          node,
          "compute",
          GoalPolicy::replace,
          impl_,
          &WorkerImpl::execute_compute,
          &WorkerImpl::accept_compute));
      action_servers_.push_back(
        std::make_unique<ActionServer<worker_types::MeasureAction>>(
          node,
          "measure",
          GoalPolicy(GoalPolicy::parallel, 3),
          impl_,
          &WorkerImpl::execute_measure));
    }
    for (const auto & server : action_servers_) {
      server->start();
    }
    servers_.start(node);
    node.watch(
      deadline_speed_,
      "late_speed",
      [impl = impl_] {impl->late_speed();},
      "speed");
    node.watch(
      deadline_say_,
      "late_say",
      [impl = impl_] {impl->late_say();},
      "say");
    node.repeat("read", [impl = impl_] {impl->read();});
    node.call_at(4.0, "poll", [impl = impl_] {impl->poll();});
  }

  /// Return what watches the topics.
  std::vector<std::shared_ptr<Deadline>> deadlines() const
  {
    return {
      deadline_speed_,
      deadline_say_,
    };
  }

  /// Ask goals that are executed to end.
  void stop() override
  {
    for (const auto & server : action_servers_) {
      server->stop();
    }
  }

  /// Destroy subscriptions and service servers; give every goal a result.
  void disconnect() override
  {
    // Action servers stay, as a client may still ask for a result; inactive ones reject goals.
    for (const auto & server : action_servers_) {
      server->end();
    }
    topics_.unsubscribe();
    service_servers_.clear();
    servers_.stop();
  }

  /// Cancel the goals that the logic has sent.
  void cancel_goals(Stop::Clock::time_point end) override
  {
    action_delegate_->cancel_until(end);
  }

  /// Wait until the last messages and results have been received.
  void flush(Stop::Clock::time_point end) override
  {
    topics_.flush(end);
    for (const auto & server : action_servers_) {
      server->flush(end);
    }
  }

private:
  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_speed_updated = in_speed_.take(data_.in_speed);
    data_.in_counter_updated = in_counter_.take(data_.in_counter);
    data_.out_counter_active = true;
    data_.out_counter_subscribers = out_counter_->get_subscription_count();
    data_.out_status_active = true;
    data_.out_status_subscribers = out_status_->get_subscription_count();
    impl_->update(data_, *std::atomic_load(config_.get()));
    if (!calls_->is_open()) {
      return;  // update returned after the node had stopped
    }
    if (data_.out_counter_active) {
      out_counter_->publish(data_.out_counter);
    }
    if (data_.out_status_active) {
      out_status_->publish(data_.out_status);
    }
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::atomic<bool> is_configured_{false};
  std::shared_ptr<Loop> loop_;
  WorkerData data_;
  Inbox<worker_types::InSpeed> in_speed_;
  Inbox<worker_types::InCounter> in_counter_;
  std::shared_ptr<Deadline> deadline_speed_ =
    std::make_shared<Deadline>(sleeper_, 0.5);
  std::shared_ptr<Deadline> deadline_say_ =
    std::make_shared<Deadline>(sleeper_, 1.0);
  Topics topics_;
  std::shared_ptr<rclcpp::Publisher<worker_types::OutCounter>> out_counter_;
  std::shared_ptr<rclcpp::Publisher<worker_types::OutStatus>> out_status_;
  std::shared_ptr<RosActionClient<worker_types::ActionDelegate>> action_delegate_;
  MissingServers servers_;
  std::shared_ptr<WorkerImpl> impl_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
};

/// A managed node that runs its logic at a fixed frequency while it is active.
class WorkerNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit WorkerNode(const rclcpp::NodeOptions & options)
  : ManagedNode("worker", options)
  {
    declare_parameters();
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    reconfigure_callback_ = add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> & parameters) {
        return reconfigure(parameters);
      });
    fixed_ = {
      "prefix",
      "echo_topic",
      "call_topics",
      "answer_topics",
      "weights",
    };
    topic_parameters_ = {
      "echo_topic",
      "answer_topics",
      "call_topics",
    };
  }

  ~WorkerNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    const auto session =
      std::make_shared<WorkerSession>(*this, config_, loop_, diagnostics_.renew());
    logic_ = session;
    diagnostics_.watch(session->deadlines());
    return session;
  }

  void report() override {diagnostics_.report();}

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const WorkerConfig config;
    declare(
      "prefix",
      config.prefix,
      Descriptor().set__description("What stands before a status, e.g. \"a\" < 'b' and so on"));
    declare(
      "echo_topic",
      config.echo_topic,
      Descriptor().set__description("Where things are said again"));
    declare(
      "call_topics",
      config.call_topics,
      Descriptor().set__description("Where to listen for calls"));
    declare(
      "answer_topics",
      config.answer_topics,
      Descriptor().set__description("Where to answer"));
    declare(
      "weights",
      config.weights,
      Descriptor().set__description("Weights of the inputs"));
    declare(
      "gain",
      config.gain,
      between(
        0.0,
        10.0,
        Descriptor().set__description("Gain of the output")));
    declare(
      "step",
      config.step,
      between_integers(
        1,
        std::numeric_limits<std::int64_t>::max(),
        Descriptor().set__description("How far to count in a cycle")));
    declare(
      "verbose",
      config.verbose,
      Descriptor().set__description("Whether to say more"));
    declare(
      "label",
      config.label,
      Descriptor().set__description("Name in the status"));
  }

  /// Return the current parameters.
  std::shared_ptr<const WorkerConfig> read_config() const
  {
    const auto config = std::make_shared<WorkerConfig>();
    get_parameter("prefix", config->prefix);
    get_parameter("echo_topic", config->echo_topic);
    get_parameter("call_topics", config->call_topics);
    get_parameter("answer_topics", config->answer_topics);
    get_parameter("weights", config->weights);
    get_parameter("gain", config->gain);
    get_parameter("step", config->step);
    get_parameter("verbose", config->verbose);
    get_parameter("label", config->label);
    return config;
  }

  /// Let the logic take the parameters about to be set, unless they are refused before.
  rcl_interfaces::msg::SetParametersResult reconfigure(
    const std::vector<rclcpp::Parameter> & parameters)
  {
    auto result = check(parameters);  // rclcpp calls this callback before that of the base
    const auto logic = logic_.lock();
    const std::set<std::string> names{
      "gain",
      "step",
      "verbose",
      "label",
    };
    const bool is_ours = std::any_of(
      parameters.begin(), parameters.end(), [&names](const auto & parameter) {
        return names.count(parameter.get_name()) > 0;
      });
    if (result.successful && is_ours && logic && logic->is_configured()) {
      result.reason = call_reconfigure(
        [logic, config = config_with(parameters)] {return logic->reconfigure(config);});
      result.successful = result.reason.empty();
    }
    return result;
  }

  /// Return the configuration with some parameters changed.
  WorkerConfig config_with(const std::vector<rclcpp::Parameter> & parameters) const
  {
    auto config = *std::atomic_load(config_.get());
    for (const auto & parameter : parameters) {
      const auto & name = parameter.get_name();
      if (name == "gain") {
        config.gain = parameter.get_value<double>();
      } else if (name == "step") {
        config.step = parameter.get_value<std::int64_t>();
      } else if (name == "verbose") {
        config.verbose = parameter.get_value<bool>();
      } else if (name == "label") {
        config.label = parameter.get_value<std::string>();
      }
    }
    return config;
  }

  WorkerSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const WorkerConfig>>(
    std::make_shared<const WorkerConfig>());
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<void> reconfigure_callback_;
  std::weak_ptr<WorkerSession> logic_;
  std::shared_ptr<Loop> loop_ =
    std::make_shared<Loop>(
    Sleeper(get_clock(), stop()),
    declare_frequency(FREQUENCY),
    get_logger());
  Diagnostics diagnostics_{*this, loop_};
};

/// Run the node in a process of its own.
int run_worker(int argc, char ** argv)
{
  return run_node<WorkerNode>(argc, argv);
}

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::WorkerNode)
