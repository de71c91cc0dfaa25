// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node replay: its lifecycle and its ROS interfaces.
// Generated from driver.ros_package.
// The logic is in replay_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "driver/replay_impl.hpp"
#include "driver/replay_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/managed_node.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/stop.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

namespace driver
{

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Publishers exist as long as it does.
class ReplaySession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const ReplayConfig>>;

  /// Create publishers and clients, then the logic.
  ReplaySession(
    ManagedNode & node,
    const SharedConfig & config)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop())
  {
    ReplayPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    passthrough.pub_reading =
      std::make_shared<RosPublisher<replay_types::PubReading>>(
      topics_.advertise<replay_types::PubReading>(
        node,
        "reading",
        rclcpp::SensorDataQoS()));
    impl_ = std::make_shared<ReplayImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers, and start threads.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    node.call_at(10.0, "play", [impl = impl_] {impl->play();});
  }

  /// Wait until the last messages have been received.
  void flush(Stop::Clock::time_point end) override
  {
    topics_.flush(end);
  }

private:
  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  Topics topics_;
  std::shared_ptr<ReplayImpl> impl_;
};

/// A managed node that calls its logic back while it is active.
class ReplayNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit ReplayNode(const rclcpp::NodeOptions & options)
  : ManagedNode("sensor", options)
  {
    declare_parameters();
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    fixed_ = {
      "scale",
      "file",
    };
  }

  ~ReplayNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ReplaySession>(*this, config_);
  }

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const ReplayConfig config;
    declare(
      "scale",
      config.scale,
      Descriptor().set__description("How long one unit of the sensor is, m"));
    declare(
      "file",
      config.file,
      Descriptor().set__description("Where the readings are"));
  }

  /// Return the current parameters.
  std::shared_ptr<const ReplayConfig> read_config() const
  {
    const auto config = std::make_shared<ReplayConfig>();
    get_parameter("scale", config->scale);
    get_parameter("file", config->file);
    return config;
  }

  ReplaySession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const ReplayConfig>>(
    std::make_shared<const ReplayConfig>());
  std::shared_ptr<void> parameters_callback_;
};

/// Run the node in a process of its own.
int run_replay(int argc, char ** argv)
{
  return run_node<ReplayNode>(argc, argv);
}

}  // namespace driver

RCLCPP_COMPONENTS_REGISTER_NODE(driver::ReplayNode)
