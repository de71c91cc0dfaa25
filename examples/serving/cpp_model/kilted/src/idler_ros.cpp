// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its life-cycle and its connections to ROS.
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
/// What sends is connected when the node is configured, what receives when it is activated.
class IdlerNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; the rest is done when the node is configured.
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

  /// End in good order, from whatever state.
  ~IdlerNode() override
  {
    const bool finalized =
      get_current_state().id() == lifecycle_msgs::msg::State::PRIMARY_STATE_FINALIZED;
    if (!finalized && get_node_base_interface()->get_context()->is_valid()) {
      shutdown();
    }
    release();
  }

  /// Connect what sends, then let the logic prepare itself.
  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    try {
      connect_senders();
      configured_ = impl_->configure(*current_config());
      if (configured_) {
        return CallbackReturn::SUCCESS;
      }
      RCLCPP_ERROR(get_logger(), "The logic refuses its configuration.");
    } catch (const std::exception & error) {
      RCLCPP_ERROR(get_logger(), "Cannot configure: %s", error.what());
    }
    release();
    return CallbackReturn::FAILURE;
  }

  /// Connect what receives.
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    const auto result = LifecycleNode::on_activate(state);
    connect_receivers();
    return result;
  }

  /// Disconnect what receives, once the callbacks that run have ended.
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State & state) override
  {
    disconnect_receivers();
    return LifecycleNode::on_deactivate(state);
  }

  /// Let go of all that configuring made.
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

  /// Return the parameters as they are now.
  IdlerConfig read_config() const
  {
    IdlerConfig config;
    return config;
  }

  std::shared_ptr<const IdlerConfig> current_config() {return config_;}

  /// Make all that the logic can use, then the logic.
  void connect_senders()
  {
    IdlerPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    impl_ = std::make_unique<IdlerImpl>(passthrough);
  }

  /// Make all that calls the logic, each in a thread of its own.
  void connect_receivers()
  {
  }

  /// Let no callback of the logic run any more.
  void disconnect_receivers()
  {
  }

  /// Disconnect from ROS, and let the logic clean up.
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
