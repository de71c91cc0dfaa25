// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in idler_impl.cpp.

#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/managed_node.hpp"
#include "ros/ros_log.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"
#include "serving/idler_impl.hpp"
#include "serving/idler_interface.hpp"

namespace serving
{

/// The logic from configure to cleanup, with its ROS interfaces.
class IdlerSession : public Session
{
public:
  using SharedConfig = std::shared_ptr<Snapshot<IdlerConfig>>;

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
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    impl_ = std::make_shared<IdlerImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*config_->get());}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
  }

  /// Destroy subscriptions and servers.
  void disconnect() override
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

  IdlerNode(const IdlerNode &) = delete;
  IdlerNode & operator=(const IdlerNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<IdlerSession>(*this, config_);
  }

  IdlerSession::SharedConfig config_ =
    std::make_shared<Snapshot<IdlerConfig>>();
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_idler_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<IdlerNode>(options);
}

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::IdlerNode)
