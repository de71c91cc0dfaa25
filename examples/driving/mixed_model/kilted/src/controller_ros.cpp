// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node controller: its lifecycle and its ROS interfaces.
// Generated from driving.ros_package.
// The logic is in controller_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "driving/controller_impl.hpp"
#include "driving/controller_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/inbox.hpp"
#include "ros/managed_node.hpp"
#include "ros/service_server.hpp"
#include "ros/stop.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

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
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const ControllerConfig>>;

  /// Create publishers and clients, then the logic.
  ControllerSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<Loop> & loop)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    loop_(loop)
  {
    ControllerPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    out_speed_ = topics_.advertise<controller_types::OutSpeed>(
      node,
      "speed");
    impl_ = std::make_shared<ControllerImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Run the update loop until the node stops.
  void work() override {loop_->run([this] {update();});}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    topics_.subscribe(
      node,
      "target_speed",
      in_target_speed_);
    service_servers_.push_back(
      create_service_server<controller_types::StopService>(
        node,
        "stop",
        impl_,
        &ControllerImpl::serve_stop));
  }

  /// Destroy subscriptions and service servers.
  void disconnect() override
  {
    topics_.unsubscribe();
    service_servers_.clear();
  }

  /// Wait until the last messages have been received.
  void flush(Stop::Clock::time_point end) override
  {
    topics_.flush(end);
  }

private:
  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_target_speed_updated = in_target_speed_.take(data_.in_target_speed);
    data_.out_speed_active = true;
    data_.out_speed_subscribers = out_speed_->get_subscription_count();
    impl_->update(data_, *std::atomic_load(config_.get()));
    if (!calls_->is_open()) {
      return;  // update returned after the node had stopped
    }
    if (data_.out_speed_active) {
      out_speed_->publish(data_.out_speed);
    }
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::shared_ptr<Loop> loop_;
  ControllerData data_;
  Inbox<controller_types::InTargetSpeed> in_target_speed_;
  Topics topics_;
  std::shared_ptr<rclcpp::Publisher<controller_types::OutSpeed>> out_speed_;
  std::shared_ptr<ControllerImpl> impl_;
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
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    fixed_ = {
      "speed_limit",
    };
  }

  ~ControllerNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ControllerSession>(*this, config_, loop_);
  }

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const ControllerConfig config;
    declare(
      "speed_limit",
      config.speed_limit,
      Descriptor().set__description("Highest speed, m/s"));
  }

  /// Return the current parameters.
  std::shared_ptr<const ControllerConfig> read_config() const
  {
    const auto config = std::make_shared<ControllerConfig>();
    get_parameter("speed_limit", config->speed_limit);
    return config;
  }

  ControllerSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const ControllerConfig>>(
    std::make_shared<const ControllerConfig>());
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<Loop> loop_ =
    std::make_shared<Loop>(
    Sleeper(get_clock(), stop()),
    declare_frequency(FREQUENCY),
    get_logger());
};

/// Run the node in a process of its own.
int run_controller(int argc, char ** argv)
{
  return run_node<ControllerNode>(argc, argv);
}

}  // namespace driving

RCLCPP_COMPONENTS_REGISTER_NODE(driving::ControllerNode)
