// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in clerk_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/managed_node.hpp"
#include "ros/service_server.hpp"
#include "ros/stop.hpp"
#include "ros/timing.hpp"
#include "serving/clerk_impl.hpp"
#include "serving/clerk_interface.hpp"

namespace serving
{

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Service servers exist while it is active. Action servers exist from its first activation on;
/// while inactive, they reject goals.
class ClerkSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const ClerkConfig>>;

  /// Create publishers and clients, then the logic.
  ClerkSession(
    ManagedNode & node,
    const SharedConfig & config)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop())
  {
    ClerkPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    impl_ = std::make_shared<ClerkImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    service_servers_.push_back(
      create_service_server<clerk_types::GreetService>(
        node,
        "greet",
        impl_,
        &ClerkImpl::serve_greet));
    service_servers_.push_back(
      create_service_server<clerk_types::OpenService>(
        node,
        "~/open",
        impl_,
        &ClerkImpl::serve_open));
    if (action_servers_.empty()) {
      action_servers_.push_back(
        std::make_unique<ActionServer<clerk_types::CountAction>>(
          node,
          "count",
          GoalPolicy::replace,
          impl_,
          &ClerkImpl::execute_count));
    }
    for (const auto & server : action_servers_) {
      server->start();
    }
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
    service_servers_.clear();
  }

  /// Wait until the last results have been received.
  void flush(Stop::Clock::time_point end) override
  {
    for (const auto & server : action_servers_) {
      server->flush(end);
    }
  }

private:
  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::shared_ptr<ClerkImpl> impl_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
};

/// A managed node that calls its logic back while it is active.
class ClerkNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit ClerkNode(const rclcpp::NodeOptions & options)
  : ManagedNode("clerk", options)
  {
    declare_parameters();
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    fixed_ = {
      "greeting",
      "patience",
    };
  }

  ~ClerkNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ClerkSession>(*this, config_);
  }

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const ClerkConfig config;
    declare(
      "greeting",
      config.greeting,
      Descriptor().set__description("What to say"));
    declare(
      "patience",
      config.patience,
      Descriptor().set__description("Time for a step, s"));
  }

  /// Return the current parameters.
  std::shared_ptr<const ClerkConfig> read_config() const
  {
    const auto config = std::make_shared<ClerkConfig>();
    get_parameter("greeting", config->greeting);
    get_parameter("patience", config->patience);
    return config;
  }

  ClerkSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const ClerkConfig>>(
    std::make_shared<const ClerkConfig>());
  std::shared_ptr<void> parameters_callback_;
};

/// Run the node in a process of its own.
int run_clerk(int argc, char ** argv)
{
  return run_node<ClerkNode>(argc, argv);
}

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::ClerkNode)
