// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node observer: its lifecycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in observer_impl.cpp.

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "all_kinds/observer_impl.hpp"
#include "all_kinds/observer_interface.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "ros/calls.hpp"
#include "ros/cycle_counts.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/managed_node.hpp"
#include "ros/parameters.hpp"
#include "ros/ros_log.hpp"
#include "ros/session.hpp"
#include "ros/sleeper.hpp"
#include "ros/snapshot.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 12.5;  // Hz

/// The logic from configure to cleanup, with its ROS interfaces.
///
/// Subscriptions exist while it is active.
class ObserverSession : public Session
{
public:
  using SharedConfig = std::shared_ptr<Snapshot<ObserverConfig>>;

  /// Create publishers and clients, then the logic.
  ObserverSession(
    ManagedNode & node,
    const SharedConfig & config,
    const std::shared_ptr<CycleCounts> & cycles)
  : config_(config),
    calls_(node.calls()),
    sleeper_(node.get_clock(), node.stop()),
    logger_(node.get_logger()),
    cycles_(cycles)
  {
    ObserverPassthrough passthrough;
    passthrough.log = make_logger(node.get_logger());
    passthrough.now = [clock = node.get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.sleep = [sleeper = sleeper_](double seconds) {
        return sleeper.sleep_for(seconds);
      };
    impl_ = std::make_shared<ObserverImpl>(passthrough);
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
      "/status",
      in_status_);
  }

  /// Destroy subscriptions and servers.
  void disconnect() override
  {
    subscriptions_.clear();
  }

private:
  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_status_updated = in_status_.take(data_.in_status);
    impl_->update(data_, *config_->get());
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

  SharedConfig config_;
  std::shared_ptr<Calls> calls_;
  Sleeper sleeper_;
  rclcpp::Logger logger_;
  std::shared_ptr<CycleCounts> cycles_;
  ObserverData data_;
  Inbox<observer_types::InStatus> in_status_;
  std::shared_ptr<ObserverImpl> impl_;
  std::vector<std::shared_ptr<void>> subscriptions_;
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
    config_->set(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        config_->set(read_config());
      });
    fix_while_configured(
      {
        "limit",
      });
  }

  ~ObserverNode() override {end();}

  ObserverNode(const ObserverNode &) = delete;
  ObserverNode & operator=(const ObserverNode &) = delete;

private:
  std::shared_ptr<Session> make_session() override
  {
    return std::make_shared<ObserverSession>(*this, config_, cycles_);
  }

  void declare_parameters()
  {
    const ObserverConfig config;
    declare_parameter(
      "limit",
      config.limit,
      described("How many to keep"));
  }

  /// Return the current parameters.
  ObserverConfig read_config() const
  {
    ObserverConfig config;
    get_parameter("limit", config.limit);
    return config;
  }

  ObserverSession::SharedConfig config_ =
    std::make_shared<Snapshot<ObserverConfig>>();
  std::shared_ptr<void> parameters_callback_;
  std::shared_ptr<CycleCounts> cycles_ = std::make_shared<CycleCounts>();
};

/// Create the node for its own executable.
std::shared_ptr<ManagedNode> make_observer_node(
  const rclcpp::NodeOptions & options)
{
  return std::make_shared<ObserverNode>(options);
}

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::ObserverNode)
