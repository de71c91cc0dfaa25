// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in clerk_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/action_server.hpp"
#include "ros/calls.hpp"
#include "ros/managed_node.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_log.hpp"
#include "ros/service_server.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"
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
  using SharedConfig = std::shared_ptr<Snapshot<ClerkConfig>>;

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
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    impl_ = std::make_shared<ClerkImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*config_->get());}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    serve<clerk_types::GreetService>(
      node,
      "greet",
      "service greet",
      &ClerkImpl::serve_greet);
    serve<clerk_types::OpenService>(
      node,
      "~/open",
      "service ~/open",
      &ClerkImpl::serve_open);
    if (served_actions_.empty()) {
      serve_action<clerk_types::CountAction>(
        node,
        "count",
        GoalPolicy::replace,
        "action count",
        &ClerkImpl::execute_count);
    }
    for (const auto & server : served_actions_) {
      server->start();
    }
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
    service_servers_.clear();
  }

  /// Wait until the last results have been received.
  void flush(Stop::Clock::time_point end) override
  {
    for (const auto & server : served_actions_) {
      server->flush(end);
    }
  }

private:
  /// Create a service server whose requests go to a method of the logic.
  template<typename Service>
  void serve(
    ManagedNode & node,
    const std::string & name,
    const std::string & label,
    void (ClerkImpl::* answer)(
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
    void (ClerkImpl::* execute)(Goal<Action> &))
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
  std::shared_ptr<ClerkImpl> impl_;
  std::vector<std::shared_ptr<void>> service_servers_;
  std::vector<std::unique_ptr<ActionServerBase>> served_actions_;
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
    config_->set(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        config_->set(read_config());
      });
    fix_while_configured(
      {
        "greeting",
        "patience",
      });
  }

  ~ClerkNode() override {end();}

  ClerkNode(const ClerkNode &) = delete;
  ClerkNode & operator=(const ClerkNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ClerkSession>(*this, config_);
  }

  void declare_parameters()
  {
    const ClerkConfig config;
    declare_parameter(
      "greeting",
      config.greeting,
      described("What to say"));
    declare_parameter(
      "patience",
      config.patience,
      described("Time for a step, s"));
  }

  /// Return the current parameters.
  ClerkConfig read_config() const
  {
    ClerkConfig config;
    get_parameter("greeting", config.greeting);
    get_parameter("patience", config.patience);
    return config;
  }

  ClerkSession::SharedConfig config_ =
    std::make_shared<Snapshot<ClerkConfig>>();
  std::shared_ptr<void> parameters_callback_;
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_clerk_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<ClerkNode>(options);
}

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::ClerkNode)
