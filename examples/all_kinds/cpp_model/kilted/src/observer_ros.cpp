// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node observer: its life-cycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in observer_impl.cpp.

#include <chrono>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "all_kinds/observer_impl.hpp"
#include "all_kinds/observer_interface.hpp"
#include "inbox.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "loop.hpp"
#include "parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "ros_log.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 12.5;  // Hz
constexpr int QUEUE = 10;  // messages kept for a topic, unless its QoS is overridden

/// A managed node that runs its logic at a fixed frequency while it is active.
///
/// Publishers and clients exist from configure on, subscriptions and servers while it is active.
class ObserverNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; everything else is created in configure.
  explicit ObserverNode(const rclcpp::NodeOptions & options)
  : LifecycleNode("observer", options)
  {
    declare_parameters();
    config_ = std::make_shared<ObserverConfig>(read_config());
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start();
        });
    }
  }

  ObserverNode(const ObserverNode &) = delete;
  ObserverNode & operator=(const ObserverNode &) = delete;

  /// Shut down from any state.
  ~ObserverNode() override
  {
    const bool finalized =
      get_current_state().id() == lifecycle_msgs::msg::State::PRIMARY_STATE_FINALIZED;
    if (!finalized && get_node_base_interface()->get_context()->is_valid()) {
      shutdown();
    }
    release();
  }

  /// Create publishers and clients, then configure the logic.
  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    try {
      connect_senders();
      configured_ = impl_->configure(*current_config());
      if (configured_) {
        return CallbackReturn::SUCCESS;
      }
      RCLCPP_ERROR(get_logger(), "The logic rejected its configuration.");
    } catch (const std::exception & error) {
      RCLCPP_ERROR(get_logger(), "Cannot configure: %s", error.what());
    }
    release();
    return CallbackReturn::FAILURE;
  }

  /// Create subscriptions and servers, and start the loop.
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    const auto result = LifecycleNode::on_activate(state);
    connect_receivers();
    return result;
  }

  /// Stop the loop and destroy subscriptions and servers, once running callbacks have returned.
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State & state) override
  {
    disconnect_receivers();
    return LifecycleNode::on_deactivate(state);
  }

  /// Release everything created in configure.
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    release();
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_shutdown(const rclcpp_lifecycle::State &) override
  {
    release();
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_error(const rclcpp_lifecycle::State &) override
  {
    release();
    return CallbackReturn::SUCCESS;
  }

private:
  /// Configure and activate the node.
  void start()
  {
    start_timer_->cancel();
    if (configure().id() == lifecycle_msgs::msg::State::PRIMARY_STATE_INACTIVE) {
      activate();
    }
  }

  void declare_parameters()
  {
    declare_parameter(
      "autostart",
      true,
      read_only("Whether the node configures and activates itself."));
    const ObserverConfig config;
    declare_parameter(
      "limit",
      config.limit,
      read_only("How many to keep"));
  }

  /// Return the current parameters.
  ObserverConfig read_config() const
  {
    ObserverConfig config;
    get_parameter("limit", config.limit);
    return config;
  }

  std::shared_ptr<const ObserverConfig> current_config() {return config_;}

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ObserverPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    data_ = ObserverData();
    impl_ = std::make_unique<ObserverImpl>(passthrough);
  }

  /// Create subscriptions, servers and the update loop.
  void connect_receivers()
  {
    subscribe(
      "/status",
      in_status_);
    loop_ = std::make_unique<Loop>(
      *this,
      FREQUENCY,
      [this] {
        update();
      });
  }

  /// Stop all callbacks of the logic.
  void disconnect_receivers()
  {
    loop_.reset();
    subscriptions_.clear();
  }

  /// Destroy all connections to ROS and clean up the logic.
  void release()
  {
    disconnect_receivers();
    if (configured_) {
      configured_ = false;
      try {
        impl_->cleanup();
      } catch (const std::exception & error) {
        RCLCPP_ERROR(get_logger(), "Cannot clean up: %s", error.what());
      }
    }
    impl_.reset();
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_status_updated = in_status_.take(data_.in_status);
    impl_->update(data_, *current_config());
  }

  /// Return subscription options that allow QoS overrides.
  static rclcpp::SubscriptionOptions overridable()
  {
    rclcpp::SubscriptionOptions options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    return options;
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    const std::string & topic,
    const Inbox<Message> & inbox)
  {
    subscriptions_.push_back(
      create_subscription<Message>(
        topic,
        QUEUE,
        [inbox](std::unique_ptr<Message> message) {
          inbox.put(std::move(message));
        },
        overridable()));
  }

  std::shared_ptr<const ObserverConfig> config_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  ObserverData data_;
  Inbox<observer_types::InStatus> in_status_;
  std::unique_ptr<ObserverImpl> impl_;
  bool configured_ = false;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::ObserverNode)
