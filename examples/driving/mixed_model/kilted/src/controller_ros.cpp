// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node controller: its lifecycle and its ROS interfaces.
// Generated from driving.ros_package.
// The logic is in controller_impl.cpp.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "driving/controller_impl.hpp"
#include "driving/controller_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/cycle_counts.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/managed_node.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_log.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/service_server.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"

namespace driving
{

constexpr double FREQUENCY = 100.0;  // Hz

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Publishers exist as long as it does. Subscriptions and service servers exist while it is
/// active.
class ControllerSession : public Session
{
public:
  using SharedConfig = std::shared_ptr<Snapshot<ControllerConfig>>;

  /// Create publishers and clients, then the logic.
  ControllerSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<CycleCounts> & cycles)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    logger_(node.get_logger()),
    cycles_(cycles)
  {
    ControllerPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    out_speed_ = advertise<controller_types::OutSpeed>(
      node,
      "speed");
    impl_ = std::make_shared<ControllerImpl>(passthrough);
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
      "target_speed",
      in_target_speed_);
    serve<controller_types::StopService>(
      node,
      "stop",
      "service stop",
      &ControllerImpl::serve_stop);
  }

  /// Destroy subscriptions and servers.
  void disconnect() override
  {
    subscriptions_.clear();
    service_servers_.clear();
  }

  /// Wait until the last messages have been received.
  void flush(Stop::Clock::time_point end) override
  {
    wait_until_received(publishers_, end);
  }

private:
  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_target_speed_updated = in_target_speed_.take(data_.in_target_speed);
    data_.out_speed_active = true;
    impl_->update(data_, *config_->get());
    if (!calls_->is_open()) {
      return;  // It came too late: the node has stopped.
    }
    if (data_.out_speed_active) {
      out_speed_->publish(data_.out_speed);
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

  /// Create a service server whose requests go to a method of the logic.
  template<typename Service>
  void serve(
    ManagedNode & node,
    const std::string & name,
    const std::string & label,
    void (ControllerImpl::* answer)(
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

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  rclcpp::Logger logger_;
  std::shared_ptr<CycleCounts> cycles_;
  ControllerData data_;
  Inbox<controller_types::InTargetSpeed> in_target_speed_;
  std::vector<rclcpp::PublisherBase::SharedPtr> publishers_;
  std::shared_ptr<RosPublisher<controller_types::OutSpeed>> out_speed_;
  std::shared_ptr<ControllerImpl> impl_;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::vector<std::shared_ptr<void>> service_servers_;
};

/// A managed node that runs its logic at a fixed frequency while it is active.
class ControllerNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit ControllerNode(const rclcpp::NodeOptions & options)
  : ManagedNode("controller", options)
  {
    declare_parameters();
    config_->set(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        config_->set(read_config());
      });
    fix_while_configured(
      {
        "speed_limit",
      });
  }

  ~ControllerNode() override {end();}

  ControllerNode(const ControllerNode &) = delete;
  ControllerNode & operator=(const ControllerNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ControllerSession>(*this, config_, cycles_);
  }

  void declare_parameters()
  {
    const ControllerConfig config;
    declare_parameter(
      "speed_limit",
      config.speed_limit,
      described("Highest speed, m/s"));
  }

  /// Return the current parameters.
  ControllerConfig read_config() const
  {
    ControllerConfig config;
    get_parameter("speed_limit", config.speed_limit);
    return config;
  }

  ControllerSession::SharedConfig config_ =
    std::make_shared<Snapshot<ControllerConfig>>();
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<CycleCounts> cycles_ = std::make_shared<CycleCounts>();
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_controller_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<ControllerNode>(options);
}

}  // namespace driving

RCLCPP_COMPONENTS_REGISTER_NODE(driving::ControllerNode)
