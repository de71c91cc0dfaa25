// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node observer: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in observer_impl.cpp.

#include <memory>
#include <string>
#include <vector>

#include "all_kinds/observer_impl.hpp"
#include "all_kinds/observer_interface.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/inbox.hpp"
#include "ros/managed_node.hpp"
#include "ros/synchronizer.hpp"
#include "ros/timing.hpp"
#include "ros/topics.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 12.5;  // Hz

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Subscriptions exist while it is active.
class ObserverSession : public Session
{
public:
  /// The current parameters: replaced by atomic_store, read by atomic_load.
  using SharedConfig = std::shared_ptr<std::shared_ptr<const ObserverConfig>>;

  /// Create publishers and clients, then the logic.
  ObserverSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<Loop> & loop)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    loop_(loop)
  {
    ObserverPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {return Time(clock->now().nanoseconds());};
    passthrough.sleep = [sleeper = sleeper_](double seconds) {return sleeper.sleep_for(seconds);};
    passthrough.fail = [calls = calls_](const std::string & reason) {
        calls->fail("The logic failed: " + reason);
      };
    impl_ = std::make_shared<ObserverImpl>(passthrough);
  }

  bool configure() override {return impl_->configure(*std::atomic_load(config_.get()));}
  bool activate() override {return impl_->activate();}
  void deactivate() override {impl_->deactivate();}
  void cleanup() override {impl_->cleanup();}

  /// Run the update loop until the node stops.
  void work() override {loop_->run([this] {update(); return true;});}

  /// Create subscriptions and servers.
  void connect([[maybe_unused]] ManagedNode & node) override
  {
    topics_.subscribe(
      node,
      "/status",
      in_status_);
    const auto synchronizer_pair = synchronize<
      observer_types::PairLeft,
      observer_types::PairRight>(
      node,
      "pair",
      impl_,
      &ObserverImpl::receive_pair,
      5);
    topics_.subscribe_input<0>(
      node,
      "left",
      synchronizer_pair);
    topics_.subscribe_input<1>(
      node,
      "~/right",
      synchronizer_pair);
  }

  /// Destroy subscriptions and service servers.
  void disconnect() override
  {
    topics_.unsubscribe();
  }

private:
  /// Run one cycle: take the latest messages, call update.
  void update()
  {
    data_.in_status_updated = in_status_.take(data_.in_status);
    impl_->update(data_, *std::atomic_load(config_.get()));
  }

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  std::shared_ptr<Loop> loop_;
  ObserverData data_;
  Inbox<observer_types::InStatus> in_status_;
  Topics topics_;
  std::shared_ptr<ObserverImpl> impl_;
};

/// A managed node that runs its logic at a fixed frequency while it is active.
class ObserverNode : public ManagedNode
{
public:
  /// Declare the parameters; configure creates the session.
  explicit ObserverNode(const rclcpp::NodeOptions & options)
  : ManagedNode("observer", options)
  {
    declare_parameters();
    std::atomic_store(config_.get(), read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        std::atomic_store(config_.get(), read_config());
      });
    fixed_ = {
      "limit",
    };
  }

  ~ObserverNode() override {end();}

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ObserverSession>(*this, config_, loop_);
  }

  void declare_parameters()
  {
    using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
    const ObserverConfig config;
    declare(
      "limit",
      config.limit,
      Descriptor().set__description("How many to keep"));
  }

  /// Return the current parameters.
  std::shared_ptr<const ObserverConfig> read_config() const
  {
    const auto config = std::make_shared<ObserverConfig>();
    get_parameter("limit", config->limit);
    return config;
  }

  ObserverSession::SharedConfig config_ =
    std::make_shared<std::shared_ptr<const ObserverConfig>>(
    std::make_shared<const ObserverConfig>());
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<Loop> loop_ =
    std::make_shared<Loop>(
    Sleeper(get_clock(), stop()),
    declare_frequency(FREQUENCY),
    get_logger());
};

/// Run the node in a process of its own.
int run_observer(int argc, char ** argv)
{
  return run_node<ObserverNode>(argc, argv);
}

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::ObserverNode)
