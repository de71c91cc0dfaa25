// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node sensor: its lifecycle and its ROS interfaces.
// Generated from driver.ros_package.
// The logic is in sensor_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "driver/sensor_impl.hpp"
#include "driver/sensor_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/diagnostics.hpp"
#include "ros/managed_node.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/stop.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

namespace driver
{

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Publishers exist as long as it does.
class SensorSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const SensorConfig>>;

  /// Create publishers and clients, then the logic.
  SensorSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<LogicStatus> & status)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop())
  {
    SensorPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    passthrough.diagnostics = status;
    passthrough.node = &node;
    passthrough.pub_reading =
      std::make_shared<RosPublisher<sensor_types::PubReading>>(
      topics_.advertise<sensor_types::PubReading>(
        node,
        "reading",
        rclcpp::SensorDataQoS()));
    impl_ = std::make_shared<SensorImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers, and start threads.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    node.repeat("read", [impl = impl_] {impl->read();});
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
  std::shared_ptr<SensorImpl> impl_;
};

/// A managed node that calls its logic back while it is active.
class SensorNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit SensorNode(const rclcpp::NodeOptions & options)
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
      "device",
      "serial.baud",
      "serial.timeout",
    };
  }

  ~SensorNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<SensorSession>(*this, config_, diagnostics_.renew());
  }

  void report() override {diagnostics_.report();}

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const SensorConfig config;
    declare(
      "scale",
      config.scale,
      Descriptor().set__description("How long one unit of the sensor is, m"));
    declare(
      "device",
      config.device,
      Descriptor().set__description("Where the sensor is"));
    declare(
      "serial.baud",
      config.serial_baud,
      among<std::int64_t>(
        "serial.baud",
        {4800, 9600, 115200},
        Descriptor().set__description("Bits a second")));
    declare(
      "serial.timeout",
      config.serial_timeout,
      between(
        0.01,
        10.0,
        Descriptor().set__description("How long a reading may take, s")));
  }

  /// Return the current parameters.
  std::shared_ptr<const SensorConfig> read_config() const
  {
    const auto config = std::make_shared<SensorConfig>();
    get_parameter("scale", config->scale);
    get_parameter("device", config->device);
    get_parameter("serial.baud", config->serial_baud);
    get_parameter("serial.timeout", config->serial_timeout);
    return config;
  }

  SensorSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const SensorConfig>>(
    std::make_shared<const SensorConfig>());
  std::shared_ptr<void> parameters_callback_;
  Diagnostics diagnostics_{*this};
};

/// Run the node in a process of its own.
int run_sensor(int argc, char ** argv)
{
  return run_node<SensorNode>(argc, argv);
}

}  // namespace driver

RCLCPP_COMPONENTS_REGISTER_NODE(driver::SensorNode)
