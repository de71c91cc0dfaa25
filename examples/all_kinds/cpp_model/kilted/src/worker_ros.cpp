// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node worker: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in worker_impl.cpp.

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "all_kinds/worker_impl.hpp"
#include "all_kinds/worker_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/cycle_counts.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/managed_node.hpp"
#include "ros/missing_servers.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_action_client.hpp"
#include "ros/ros_log.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/ros_service_client.hpp"
#include "ros/ros_transforms.hpp"
#include "ros/service_server.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"

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
  using SharedConfig = std::shared_ptr<Snapshot<WorkerConfig>>;

  /// Create publishers and clients, then the logic.
  WorkerSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<CycleCounts> & cycles)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    logger_(node.get_logger()),
    cycles_(cycles)
  {
    WorkerPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    out_counter_ = advertise<worker_types::OutCounter>(
      node,
      "counter");
    out_status_ = advertise<worker_types::OutStatus>(
      node,
      "/status");
    passthrough.pub_echo = advertise<worker_types::PubEcho>(
      node,
      "echo");
    passthrough.pub_empty = advertise<worker_types::PubEmpty>(
      node,
      "~/empty");
    const auto client_permit =
      std::make_shared<RosServiceClient<worker_types::ClientPermit>>(
      node,
      "permit");
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

  bool configure() override {return impl_->configure(*config_->get());}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Run the update loop until the node stops.
  void work() override
  {
    Loop loop(sleeper_, FREQUENCY, logger_, *cycles_);
    loop.run([this] {update();});
  }

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    subscribe(
      node,
      "speed",
      in_speed_);
    subscribe(
      node,
      "counter",
      in_counter_);
    subscribe_direct<worker_types::SayMessage>(
      node,
      "say",
      "topic say",
      &WorkerImpl::receive_say);
    serve<worker_types::ResetService>(
      node,
      "reset",
      "service reset",
      &WorkerImpl::serve_reset);
    serve<worker_types::EnableService>(
      node,
      "enable",
      "service enable",
      &WorkerImpl::serve_enable);
    if (served_actions_.empty()) {
      serve_action<worker_types::ComputeAction>(
        node,
        "compute",
        GoalPolicy::replace,
        "action compute",
        &WorkerImpl::execute_compute);
    }
    for (const auto & server : served_actions_) {
      server->start();
    }
    servers_.start(node);
  }

  /// Ask goals that are executed to end.
  void stop() override
  {
    for (const auto & server : served_actions_) {
      server->stop();
    }
  }

  /// Destroy subscriptions and servers; give every goal a result.
  void disconnect() override
  {
    // They stay, as a client may ask for a result later on; while inactive they reject goals.
    for (const auto & server : served_actions_) {
      server->end();
    }
    subscriptions_.clear();
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
    wait_until_received(publishers_, end);
    for (const auto & server : served_actions_) {
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
    data_.out_status_active = true;
    impl_->update(data_, *config_->get());
    if (!calls_->is_open()) {
      return;  // It came too late: the node has stopped.
    }
    if (data_.out_counter_active) {
      out_counter_->publish(data_.out_counter);
    }
    if (data_.out_status_active) {
      out_status_->publish(data_.out_status);
    }
  }

  /// Create a publisher or subscription whose QoS can be overridden by parameters.
  template<typename Options, typename Create>
  static auto create_overridable(Options options, const Create & create)
  {
    options.qos_overriding_options = {
      rclcpp::QosPolicyKind::Depth,
      rclcpp::QosPolicyKind::Durability,
      rclcpp::QosPolicyKind::History,
      rclcpp::QosPolicyKind::Reliability};
    try {
      return create(options);
    } catch (const std::invalid_argument &) {
      // Within a process rclcpp lacks some policies, which the middleware has.
      options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
      return create(options);
    }
  }

  template<typename Message>
  std::shared_ptr<RosPublisher<Message>> advertise(
    ManagedNode & node,
    const std::string & topic,
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    const auto publisher = create_overridable(
      rclcpp::PublisherOptions(),
      [&](const rclcpp::PublisherOptions & options) {
        return rclcpp::create_publisher<Message>(node, topic, qos, options);
      });
    publishers_.push_back(publisher);
    return std::make_shared<RosPublisher<Message>>(
      publisher, node.get_node_options().use_intra_process_comms());
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ManagedNode & node,
    const std::string & topic,
    Inbox<Message> & inbox,
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    inbox = Inbox<Message>();  // Nothing of before is new.
    const auto receive = [inbox](std::unique_ptr<Message> message) {
        inbox.put(std::move(message));
      };
    subscriptions_.push_back(
      create_overridable(
        rclcpp::SubscriptionOptions(),
        [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, receive, options);
        }));
  }

  /// Subscribe to a topic whose messages go directly to a method of the logic.
  template<typename Message>
  void subscribe_direct(
    ManagedNode & node,
    const std::string & topic,
    const std::string & label,
    void (WorkerImpl::* receive)(const Message &),
    const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    const auto handle = [impl = impl_, calls = calls_, pass = calls_->pass(), label, receive](
      const Message & message) {
        calls->run(pass, label, [&] {(impl.get()->*receive)(message);});
      };
    rclcpp::SubscriptionOptions in_its_thread;
    in_its_thread.callback_group = node.callback_group("topic", topic);
    subscriptions_.push_back(
      create_overridable(
        in_its_thread,
        [&](const rclcpp::SubscriptionOptions & options) {
          return node.create_subscription<Message>(topic, qos, handle, options);
        }));
  }

  /// Create a service server whose requests go to a method of the logic.
  template<typename Service>
  void serve(
    ManagedNode & node,
    const std::string & name,
    const std::string & label,
    void (WorkerImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    service_servers_.push_back(
      create_service_server<Service>(
        node,
        name,
        label,
        [impl = impl_, answer](const auto & request, auto & response) {
          (impl.get()->*answer)(request, response);
        }));
  }

  /// Create an action server whose goals go to a method of the logic.
  template<typename Action>
  void serve_action(
    ManagedNode & node,
    const std::string & name,
    GoalPolicy policy,
    const std::string & label,
    void (WorkerImpl::* execute)(Goal<Action> &))
  {
    served_actions_.push_back(
      std::make_unique<ActionServer<Action>>(
        node,
        name,
        policy,
        label,
        [impl = impl_, execute](Goal<Action> & goal) {
          (impl.get()->*execute)(goal);
        }));
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  rclcpp::Logger logger_;
  std::shared_ptr<CycleCounts> cycles_;
  WorkerData data_;
  Inbox<worker_types::InSpeed> in_speed_;
  Inbox<worker_types::InCounter> in_counter_;
  std::vector<rclcpp::PublisherBase::SharedPtr> publishers_;
  std::shared_ptr<RosPublisher<worker_types::OutCounter>> out_counter_;
  std::shared_ptr<RosPublisher<worker_types::OutStatus>> out_status_;
  std::shared_ptr<RosActionClient<worker_types::ActionDelegate>> action_delegate_;
  MissingServers servers_;
  std::shared_ptr<WorkerImpl> impl_;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> served_actions_;
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
    config_->set(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        config_->set(read_config());
      });
    fix_while_configured(
      {
        "prefix",
        "weights",
      });
  }

  ~WorkerNode() override {end();}

  WorkerNode(const WorkerNode &) = delete;
  WorkerNode & operator=(const WorkerNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<WorkerSession>(*this, config_, cycles_);
  }

  void declare_parameters()
  {
    const WorkerConfig config;
    declare_parameter(
      "prefix",
      config.prefix,
      described("What stands before a status, e.g. \"a\" < 'b' and so on"));
    declare_parameter(
      "weights",
      config.weights,
      described("Weights of the inputs"));
    declare_parameter(
      "gain",
      config.gain,
      between<double>(
        0.0,
        10.0,
        described("Gain of the output")));
    declare_parameter(
      "step",
      config.step,
      between<std::int64_t>(
        1,
        std::numeric_limits<std::int64_t>::max(),
        described("How far to count in a cycle")));
    declare_parameter(
      "verbose",
      config.verbose,
      described("Whether to say more"));
    declare_parameter(
      "label",
      config.label,
      described("Name in the status"));
  }

  /// Return the current parameters.
  WorkerConfig read_config() const
  {
    WorkerConfig config;
    get_parameter("prefix", config.prefix);
    get_parameter("weights", config.weights);
    get_parameter("gain", config.gain);
    get_parameter("step", config.step);
    get_parameter("verbose", config.verbose);
    get_parameter("label", config.label);
    return config;
  }

  WorkerSession::SharedConfig config_ =
    std::make_shared<Snapshot<WorkerConfig>>();
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<CycleCounts> cycles_ = std::make_shared<CycleCounts>();
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_worker_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<WorkerNode>(options);
}

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::WorkerNode)
