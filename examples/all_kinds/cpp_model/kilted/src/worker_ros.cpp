// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node worker: its life-cycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in worker_impl.cpp.

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "action_server.hpp"
#include "all_kinds/worker_impl.hpp"
#include "all_kinds/worker_interface.hpp"
#include "callback_thread.hpp"
#include "inbox.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "loop.hpp"
#include "parameters.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "ros_action_client.hpp"
#include "ros_log.hpp"
#include "ros_publisher.hpp"
#include "ros_service_client.hpp"
#include "ros_transforms.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 20.0;  // Hz
constexpr int QUEUE = 10;  // messages kept for a topic, unless its QoS is overridden

/// A managed node that runs its logic at a fixed frequency while it is active.
///
/// Publishers and clients exist from configure on, subscriptions and servers while it is active.
class WorkerNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  /// Declare the parameters; everything else is created in configure.
  explicit WorkerNode(const rclcpp::NodeOptions & options)
  : LifecycleNode("worker", options)
  {
    declare_parameters();
    config_ = std::make_shared<WorkerConfig>(read_config());
    parameters_callback_ = add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> &) {
        set_config(read_config());
      });
    serve_action<worker_types::ComputeAction>(
      "compute",
      &WorkerImpl::execute_compute);
    if (get_parameter("autostart").as_bool()) {
      start_timer_ = create_wall_timer(
        std::chrono::seconds(0),
        [this] {
          start();
        });
    }
  }

  WorkerNode(const WorkerNode &) = delete;
  WorkerNode & operator=(const WorkerNode &) = delete;

  /// Shut down from any state.
  ~WorkerNode() override
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
    const WorkerConfig config;
    declare_parameter(
      "prefix",
      config.prefix,
      read_only("What stands before a status, e.g. \"a\" < 'b' and so on"));
    declare_parameter(
      "weights",
      config.weights,
      read_only("Weights of the inputs"));
    declare_parameter(
      "gain",
      config.gain,
      between<double>(
        0.0,
        10.0,
        changeable("Gain of the output")));
    declare_parameter(
      "step",
      config.step,
      between<std::int64_t>(
        1,
        std::numeric_limits<std::int64_t>::max(),
        changeable("How far to count in a cycle")));
    declare_parameter(
      "verbose",
      config.verbose,
      changeable("Whether to say more"));
    declare_parameter(
      "label",
      config.label,
      changeable("Name in the status"));
  }

  /// Return the current parameters.
  WorkerConfig read_config() const
  {
    WorkerConfig config;
    get_parameter("prefix", config.prefix);
    get_parameter("weights", config.weights);
    get_parameter("gain", config.gain);
    get_parameter("step", config.step);
    get_parameter("verbose", config.verbose);
    get_parameter("label", config.label);
    return config;
  }

  void set_config(const WorkerConfig & config)
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    config_ = std::make_shared<WorkerConfig>(config);
  }

  std::shared_ptr<const WorkerConfig> current_config()
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    return config_;
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    WorkerPassthrough passthrough;
    passthrough.log = make_logger(get_logger());
    passthrough.now = [clock = get_clock()] {
        return Time(clock->now().nanoseconds());
      };
    servers_.clear();
    out_counter_ = advertise<worker_types::OutCounter>(
      "counter");
    out_status_ = advertise<worker_types::OutStatus>(
      "/status");
    passthrough.pub_echo = advertise_direct<worker_types::PubEcho>(
      "echo");
    passthrough.pub_empty = advertise_direct<worker_types::PubEmpty>(
      "~/empty");
    passthrough.client_permit = watch(
      "service permit",
      std::make_shared<RosServiceClient<worker_types::ClientPermit>>(
        *this,
        "permit"));
    passthrough.action_delegate = watch(
      "action delegate",
      std::make_shared<RosActionClient<worker_types::ActionDelegate>>(
        *this,
        "delegate"));
    const auto listener = std::make_shared<RosTransformListener>(*this);
    passthrough.listener_frames = listener;
    const auto broadcaster = std::make_shared<RosTransformBroadcaster>(*this);
    passthrough.broadcaster_pose = broadcaster;
    data_ = WorkerData();
    impl_ = std::make_unique<WorkerImpl>(passthrough);
  }

  /// Create subscriptions, servers and the update loop.
  void connect_receivers()
  {
    subscribe(
      "speed",
      in_speed_);
    subscribe(
      "counter",
      in_counter_);
    subscribe_direct<worker_types::SayMessage>(
      "say",
      &WorkerImpl::receive_say);
    serve<worker_types::ResetService>(
      "reset",
      &WorkerImpl::serve_reset);
    serve<worker_types::EnableService>(
      "enable",
      &WorkerImpl::serve_enable);
    for (const auto & server : action_servers_) {
      server->start();
    }
    report_timer_ = create_wall_timer(
      std::chrono::seconds(2),
      [this] {
        report_missing_servers();
      });
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
    report_timer_.reset();
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
    out_counter_.reset();
    out_status_.reset();
    servers_.clear();
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_speed_updated = in_speed_.take(data_.in_speed);
    data_.in_counter_updated = in_counter_.take(data_.in_counter);
    data_.out_counter_active = true;
    data_.out_status_active = true;
    impl_->update(data_, *current_config());
    if (data_.out_counter_active) {
      out_counter_->publish(data_.out_counter);
    }
    if (data_.out_status_active) {
      out_status_->publish(data_.out_status);
    }
  }

  /// Register a client for the check of missing servers.
  template<typename Client>
  std::shared_ptr<Client> watch(const std::string & name, const std::shared_ptr<Client> & client)
  {
    servers_.emplace_back(name, [client] {return client->is_ready();});
    return client;
  }

  /// Warn about servers that are not available.
  void report_missing_servers()
  {
    std::string missing;
    for (const auto & [name, is_ready] : servers_) {
      if (!is_ready()) {
        missing += (missing.empty() ? "" : ", ") + name;
      }
    }
    if (!missing.empty()) {
      RCLCPP_WARN_THROTTLE(
        get_logger(), *get_clock(), 10000, "Waiting for %s.", missing.c_str());
    }
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

  /// Subscribe to a topic whose messages go directly to a callback of the logic.
  template<typename Message>
  void subscribe_direct(
    const std::string & topic,
    void (WorkerImpl::* receive)(const Message &))
  {
    const auto connect = [&](const rclcpp::CallbackGroup::SharedPtr & group) {
        auto options = overridable();
        options.callback_group = group;
        return create_subscription<Message>(
          topic,
          QUEUE,
          [this, receive](const Message & message) {
            (impl_.get()->*receive)(message);
          },
          options);
      };
    threads_.push_back(std::make_unique<CallbackThread>(*this, connect));
  }

  /// Create a service server.
  template<typename Service>
  void serve(
    const std::string & name,
    void (WorkerImpl::* answer)(
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
    void (WorkerImpl::* execute)(Goal<Action> &))
  {
    action_servers_.push_back(
      std::make_unique<ActionServer<Action>>(
        *this,
        name,
        [this, execute](Goal<Action> & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  std::shared_ptr<const WorkerConfig> config_;
  std::mutex config_mutex_;
  std::shared_ptr<void> parameters_callback_;
  rclcpp::TimerBase::SharedPtr start_timer_;
  WorkerData data_;
  Inbox<worker_types::InSpeed> in_speed_;
  Inbox<worker_types::InCounter> in_counter_;
  Sender<worker_types::OutCounter> out_counter_;
  Sender<worker_types::OutStatus> out_status_;
  std::vector<std::pair<std::string, std::function<bool()>>> servers_;
  rclcpp::TimerBase::SharedPtr report_timer_;
  std::unique_ptr<WorkerImpl> impl_;
  bool configured_ = false;
  std::vector<std::shared_ptr<void>> subscriptions_;
  std::vector<std::unique_ptr<CallbackThread>> threads_;
  std::vector<std::unique_ptr<ActionServerBase>> action_servers_;
  std::unique_ptr<Loop> loop_;
};

}  // namespace all_kinds

RCLCPP_COMPONENTS_REGISTER_NODE(all_kinds::WorkerNode)
