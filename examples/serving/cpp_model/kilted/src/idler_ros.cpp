// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its life-cycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in idler_impl.cpp.

#include <chrono>
#include <exception>
#include <memory>

#include "lifecycle_msgs/msg/state.hpp"
#include "parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "ros_log.hpp"
#include "serving/idler_impl.hpp"
#include "serving/idler_interface.hpp"

namespace serving
{

/// A managed node that calls its logic back while it is active.
///
/// Publishers and clients exist from configure on, subscriptions and servers while it is active.
class IdlerNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; everything else is created in configure.
  explicit IdlerNode(const rclcpp::NodeOptions & options)
  : LifecycleNode("idler", options)
  {
    declare_parameters();
    config_ = std::make_shared<IdlerConfig>(read_config());
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start();
        });
    }
  }

  IdlerNode(const IdlerNode &) = delete;
  IdlerNode & operator=(const IdlerNode &) = delete;

  /// Shut down from any state.
  ~IdlerNode() override
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

  /// Create subscriptions and servers.
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    const auto result = LifecycleNode::on_activate(state);
    connect_receivers();
    return result;
  }

  /// Destroy subscriptions and servers, once running callbacks have returned.
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
  }

  /// Return the current parameters.
  IdlerConfig read_config() const
  {
    IdlerConfig config;
    return config;
  }

  std::shared_ptr<const IdlerConfig> current_config() {return config_;}

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    IdlerPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    impl_ = std::make_unique<IdlerImpl>(passthrough);
  }

  /// Create subscriptions and servers.
  void connect_receivers()
  {
  }

  /// Stop all callbacks of the logic.
  void disconnect_receivers()
  {
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

  std::shared_ptr<const IdlerConfig> config_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  std::unique_ptr<IdlerImpl> impl_;
  bool configured_ = false;
};

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::IdlerNode)
