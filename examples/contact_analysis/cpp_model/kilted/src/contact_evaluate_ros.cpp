// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The node contact_evaluate: its life-cycle and its ROS interfaces.
// Generated from contact_analysis.ros_package.
// The logic is in contact_evaluate_impl.cpp.

#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "action_server.hpp"
#include "callback_thread.hpp"
#include "contact_analysis/contact_evaluate_impl.hpp"
#include "contact_analysis/contact_evaluate_interface.hpp"
#include "inbox.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "loop.hpp"
#include "parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "ros_log.hpp"
#include "ros_publisher.hpp"

namespace contact_analysis
{

constexpr double FREQUENCY = 1000.0;  // Hz
constexpr int QUEUE = 10;  // messages kept for a topic, unless its QoS is overridden

/// A managed node that runs its logic at a fixed frequency while it is active.
///
/// Publishers and clients exist from configure on, subscriptions and servers while it is active.
class ContactEvaluateNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; everything else is created in configure.
  explicit ContactEvaluateNode(const rclcpp::NodeOptions & options)
  : LifecycleNode("contact_evaluate", options)
  {
    declare_parameters();
    config_ = std::make_shared<ContactEvaluateConfig>(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        set_config(read_config());
      });
    serve_action<contact_evaluate_types::LearnAction>(
      "learn",
      &ContactEvaluateImpl::execute_learn);
    serve_action<contact_evaluate_types::EvaluateAction>(
      "evaluate",
      &ContactEvaluateImpl::execute_evaluate);
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start();
        });
    }
  }

  ContactEvaluateNode(const ContactEvaluateNode &) = delete;
  ContactEvaluateNode & operator=(const ContactEvaluateNode &) = delete;

  /// Shut down from any state.
  ~ContactEvaluateNode() override
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
  template<typename Message>
  using Sender = std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Message>>;

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
    const ContactEvaluateConfig config;
    declare_parameter(
      "samples",
      config.samples,
      read_only("number of samples accumulated for learning"));
    declare_parameter(
      "pub_sample",
      config.pub_sample,
      changeable("Whether cop sampled should be published"));
  }

  /// Return the current parameters.
  ContactEvaluateConfig read_config() const
  {
    ContactEvaluateConfig config;
    get_parameter("samples", config.samples);
    get_parameter("pub_sample", config.pub_sample);
    return config;
  }

  void set_config(const ContactEvaluateConfig & config)
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    config_ = std::make_shared<ContactEvaluateConfig>(config);
  }

  std::shared_ptr<const ContactEvaluateConfig> current_config()
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    return config_;
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ContactEvaluatePassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    passthrough.pub_plot_learn_cop = advertise_direct<contact_evaluate_types::PubPlotLearnCop>(
      "plot_learn_cop");
    data_ = ContactEvaluateData();
    impl_ = std::make_unique<ContactEvaluateImpl>(passthrough);
  }

  /// Create subscriptions, servers and the update loop.
  void connect_receivers()
  {
    subscribe(
      "cop",
      in_cop_);
    serve<contact_evaluate_types::LoadService>(
      "load",
      &ContactEvaluateImpl::serve_load);
    serve<contact_evaluate_types::StoreService>(
      "store",
      &ContactEvaluateImpl::serve_store);
    for (const auto & server : action_servers_) {
      server->start();
    }
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
    for (const auto & server : action_servers_) {
      server->stop();
    }
    threads_.clear();
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
    data_.in_cop_updated = in_cop_.take(data_.in_cop);
    impl_->update(data_, *current_config());
  }

  /// Create a publisher that allows QoS overrides.
  template<typename Message>
  Sender<Message> advertise(const std::string & topic)
  {
    rclcpp::PublisherOptions options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    return create_publisher<Message>(topic, QUEUE, options);
  }

  template<typename Message>
  std::shared_ptr<Publisher<Message>> advertise_direct(const std::string & topic)
  {
    return std::make_shared<RosPublisher<Message>>(advertise<Message>(topic));
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

  /// Create a service server.
  template<typename Service>
  void serve(
    const std::string & name,
    void (ContactEvaluateImpl::* answer)(
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
    void (ContactEvaluateImpl::* execute)(Goal<Action> &))
  {
    action_servers_.push_back(
      std::make_unique<ActionServer<Action>>(
        *this,
        name,
        [this, execute](Goal<Action> & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  std::shared_ptr<const ContactEvaluateConfig> config_;
  std::mutex config_mutex_;
  std::shared_ptr<void> parameters_callback_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  ContactEvaluateData data_;
  Inbox<contact_evaluate_types::InCop> in_cop_;
  std::unique_ptr<ContactEvaluateImpl> impl_;
  bool configured_ = false;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::vector<std::unique_ptr<CallbackThread>> threads_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace contact_analysis

RCLCPP_COMPONENTS_REGISTER_NODE(contact_analysis::ContactEvaluateNode)
