// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in idler_impl.cpp.

#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/managed_node.hpp"
#include "ros/timing.hpp"
#include "serving/idler_impl.hpp"
#include "serving/idler_interface.hpp"

namespace serving
{

/// The logic from configure to cleanup, with its ROS interfaces.
class IdlerSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const IdlerConfig>>;

  /// Create publishers and clients, then the logic.
  IdlerSession(
    ManagedNode & node,
    const SharedConfig & config)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop())
  {
    IdlerPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    impl_ = std::make_shared<IdlerImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
  }

private:
  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::shared_ptr<IdlerImpl> impl_;
};

/// A managed node that calls its logic back while it is active.
class IdlerNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit IdlerNode(const rclcpp::NodeOptions & options)
  : ManagedNode("idler", options)
  {
  }

  ~IdlerNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<IdlerSession>(*this, config_);
  }

  IdlerSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const IdlerConfig>>(
    std::make_shared<const IdlerConfig>());
};

/// Run the node in a process of its own.
int run_idler(int argc, char ** argv)
{
  return run_node<IdlerNode>(argc, argv);
}

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::IdlerNode)
