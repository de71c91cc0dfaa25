// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its life-cycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in clerk_impl.cpp.

#include <chrono>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "action_server.hpp"
#include "callback_thread.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "ros_log.hpp"
#include "serving/clerk_impl.hpp"
#include "serving/clerk_interface.hpp"

namespace serving
{

/// A managed node that calls its logic back while it is active.
///
/// Publishers and clients exist from configure on, subscriptions and servers while it is active.
class ClerkNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; everything else is created in configure.
  explicit ClerkNode(const rclcpp::NodeOptions & options)
  : LifecycleNode("clerk", options)
  {
    declare_parameters();
    config_ = std::make_shared<ClerkConfig>(read_config());
    serve_action<clerk_types::CountAction>(
      "count",
      &ClerkImpl::execute_count);
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start();
        });
    }
  }

  ClerkNode(const ClerkNode &) = delete;
  ClerkNode & operator=(const ClerkNode &) = delete;

  /// Shut down from any state.
  ~ClerkNode() override
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
    const ClerkConfig config;
    declare_parameter(
      "greeting",
      config.greeting,
      read_only("What to say"));
    declare_parameter(
      "patience",
      config.patience,
      read_only("Time for a step, s"));
  }

  /// Return the current parameters.
  ClerkConfig read_config() const
  {
    ClerkConfig config;
    get_parameter("greeting", config.greeting);
    get_parameter("patience", config.patience);
    return config;
  }

  std::shared_ptr<const ClerkConfig> current_config() {return config_;}

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ClerkPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    impl_ = std::make_unique<ClerkImpl>(passthrough);
  }

  /// Create subscriptions and servers.
  void connect_receivers()
  {
    serve<clerk_types::GreetService>(
      "greet",
      &ClerkImpl::serve_greet);
    serve<clerk_types::OpenService>(
      "~/open",
      &ClerkImpl::serve_open);
    for (const auto & server : action_servers_) {
      server->start();
    }
  }

  /// Stop all callbacks of the logic.
  void disconnect_receivers()
  {
    for (const auto & server : action_servers_) {
      server->stop();
    }
    threads_.clear();
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

  /// Create a service server.
  template<typename Service>
  void serve(
    const std::string & name,
    void (ClerkImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    const auto connect = [&](const rclcpp::CallbackGroup::SharedPtr & group) {
        return create_service<Service>(
          name,
          [this, answer](
            const std::shared_ptr<Request> & request,
            const std::shared_ptr<Response> & response) {
            (impl_.get()->*answer)(*request, *response);
          },
          rclcpp::ServicesQoS(),
          group);
      };
    threads_.push_back(std::make_unique<CallbackThread>(*this, connect));
  }

  /// Create an action server that accepts goals while the node is active.
  template<typename Action>
  void serve_action(
    const std::string & name,
    void (ClerkImpl::* execute)(Goal<Action> &))
  {
    action_servers_.push_back(
      std::make_unique<ActionServer<Action>>(
        *this,
        name,
        [this, execute](Goal<Action> & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  std::shared_ptr<const ClerkConfig> config_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  std::unique_ptr<ClerkImpl> impl_;
  bool configured_ = false;
  std::vector<std::unique_ptr<CallbackThread>> threads_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
};

}  // namespace serving

RCLCPP_COMPONENTS_REGISTER_NODE(serving::ClerkNode)
