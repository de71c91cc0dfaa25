// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its life-cycle and its connections to ROS.
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
/// What sends is connected when the node is configured, what receives when it is activated.
class ClerkNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; the rest is done when the node is configured.
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

  /// End in good order, from whatever state.
  ~ClerkNode() override
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

  /// Return the parameters as they are now.
  ClerkConfig read_config() const
  {
    ClerkConfig config;
    get_parameter("greeting", config.greeting);
    get_parameter("patience", config.patience);
    return config;
  }

  std::shared_ptr<const ClerkConfig> current_config() {return config_;}

  /// Make all that the logic can use, then the logic.
  void connect_senders()
  {
    ClerkPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    impl_ = std::make_unique<ClerkImpl>(passthrough);
  }

  /// Make all that calls the logic, each in a thread of its own.
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

  /// Let no callback of the logic run any more.
  void disconnect_receivers()
  {
    for (const auto & server : action_servers_) {
      server->stop();
    }
    threads_.clear();
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

  /// Offer a service.
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

  /// Offer an action, whose goals are accepted while the node is active.
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
