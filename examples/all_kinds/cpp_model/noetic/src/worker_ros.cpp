// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node worker: its life-cycle and its ROS interfaces.
// Generated from all_kinds.ros_package.
// The logic is in worker_impl.cpp.

#include <cstdint>
#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "action_server.hpp"
#include "all_kinds/WorkerDynamicConfig.h"
#include "all_kinds/worker_impl.hpp"
#include "all_kinds/worker_interface.hpp"
#include "callback_thread.hpp"
#include "dynamic_reconfigure/server.h"
#include "inbox.hpp"
#include "parameters.hpp"
#include "ros/ros.h"
#include "ros_action_client.hpp"
#include "ros_log.hpp"
#include "ros_publisher.hpp"
#include "ros_service_client.hpp"
#include "ros_transforms.hpp"

namespace all_kinds
{

constexpr double FREQUENCY = 20.0;  // Hz
constexpr std::uint32_t QUEUE = 10;  // messages kept for a topic

/// A node that runs its logic at a fixed frequency until shutdown.
class WorkerNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  WorkerNode()
  {
    read_parameters();
    connect_senders();
  }

  WorkerNode(const WorkerNode &) = delete;
  WorkerNode & operator=(const WorkerNode &) = delete;

  /// Destroy subscriptions and servers, then clean up the logic.
  ~WorkerNode()
  {
    spinner_.stop();
    action_servers_.clear();
    services_.clear();
    subscribers_.clear();
    threads_.clear();
    if (configured_) {
      impl_->cleanup();
    }
  }

  /// Configure the logic, connect its callbacks, and run the update loop until shutdown.
  bool run()
  {
    if (!impl_->configure(*config_)) {
      ROS_FATAL("The logic rejected its configuration.");
      return false;
    }
    configured_ = true;
    connect_receivers();
    spinner_.start();
    ros::Rate rate(FREQUENCY);
    while (ros::ok()) {
      update();
      rate.sleep();
    }
    return true;
  }

private:
  void read_parameters()
  {
    WorkerConfig config;
    read_parameter(private_, "prefix", config.prefix);
    read_parameter(private_, "weights", config.weights);
    read_parameter(private_, "gain", config.gain);
    read_parameter(private_, "step", config.step);
    read_parameter(private_, "verbose", config.verbose);
    read_parameter(private_, "label", config.label);
    config_ = std::make_shared<WorkerConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    WorkerPassthrough passthrough;
    passthrough.log = Logger(write_log);
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    out_counter_ = node_.advertise<worker_types::OutCounter>(
      "counter",
      QUEUE);
    out_status_ = node_.advertise<worker_types::OutStatus>(
      "/status",
      QUEUE);
    passthrough.pub_echo = advertise<worker_types::PubEcho>(
      node_,
      "echo");
    passthrough.pub_empty = advertise<worker_types::PubEmpty>(
      private_,
      "empty");
    passthrough.client_permit = watch(
      "service permit",
      std::make_shared<RosServiceClient<worker_types::ClientPermit>>(
        "permit"));
    passthrough.action_delegate = watch(
      "action delegate",
      std::make_shared<RosActionClient<worker_types::ActionDelegate>>(
        node_,
        "delegate"));
    const auto listener = std::make_shared<RosTransformListener>();
    passthrough.listener_frames = listener;
    const auto broadcaster = std::make_shared<RosTransformBroadcaster>();
    passthrough.broadcaster_pose = broadcaster;
    impl_ = std::make_unique<WorkerImpl>(passthrough);
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    reconfigure_server_ =
      std::make_unique<dynamic_reconfigure::Server<WorkerDynamicConfig>>(private_);
    reconfigure_server_->setCallback(
      [this](const WorkerDynamicConfig & values, std::uint32_t) {
        reconfigure(values);
      });
    subscribe(
      node_,
      "speed",
      in_speed_);
    subscribe(
      node_,
      "counter",
      in_counter_);
    subscribe_direct<worker_types::SayMessage>(
      node_,
      "say",
      &WorkerImpl::receive_say);
    serve<worker_types::ResetService>(
      node_,
      "reset",
      &WorkerImpl::serve_reset);
    serve<worker_types::EnableService>(
      node_,
      "enable",
      &WorkerImpl::serve_enable);
    serve_action<worker_types::ComputeAction>(
      node_,
      "compute",
      &WorkerImpl::execute_compute);
    timer_ = node_.createWallTimer(
      ros::WallDuration(2.0),
      [this](const ros::WallTimerEvent &) {
        report_missing_servers();
      });
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
      out_counter_.publish(data_.out_counter);
    }
    if (data_.out_status_active) {
      out_status_.publish(data_.out_status);
    }
  }

  /// Update the configuration with the changed parameters.
  void reconfigure(const WorkerDynamicConfig & values)
  {
    const auto config = std::make_shared<WorkerConfig>(*current_config());
    config->gain = values.gain;
    config->step = values.step;
    config->verbose = values.verbose;
    config->label = values.label;
    const std::lock_guard<std::mutex> lock(config_mutex_);
    config_ = config;
  }

  std::shared_ptr<const WorkerConfig> current_config()
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    return config_;
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
      ROS_WARN_THROTTLE(10.0, "Waiting for %s.", missing.c_str());
    }
  }

  template<typename Message>
  std::shared_ptr<Publisher<Message>> advertise(ros::NodeHandle & node, const std::string & topic)
  {
    return std::make_shared<RosPublisher<Message>>(node.advertise<Message>(topic, QUEUE));
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ros::NodeHandle & node,
    const std::string & topic,
    const Inbox<Message> & inbox)
  {
    subscribers_.push_back(
      node.subscribe<Message, const boost::shared_ptr<Message> &>(
        topic,
        QUEUE,
        [inbox](const boost::shared_ptr<Message> & message) {
          inbox.put(message);
        }));
  }

  /// Subscribe to a topic whose messages go directly to a callback of the logic.
  template<typename Message>
  void subscribe_direct(
    const ros::NodeHandle & node,
    const std::string & topic,
    void (WorkerImpl::* receive)(const Message &))
  {
    threads_.emplace_back(node);
    subscribers_.push_back(
      threads_.back().node().subscribe<Message>(
        topic,
        QUEUE,
        [this, receive](const boost::shared_ptr<const Message> & message) {
          (impl_.get()->*receive)(*message);
        }));
  }

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    void (WorkerImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    threads_.emplace_back(node);
    services_.push_back(
      threads_.back().node().advertiseService<Request, Response>(
        name,
        [this, answer](auto & request, auto & response) {
          (impl_.get()->*answer)(request, response);
          return true;
        }));
  }

  /// Create an action server.
  template<typename Action>
  void serve_action(
    const ros::NodeHandle & node,
    const std::string & name,
    void (WorkerImpl::* execute)(Goal<Action> &))
  {
    action_servers_.push_back(
      std::make_shared<ActionServer<Action>>(
        node,
        name,
        [this, execute](auto & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  std::shared_ptr<const WorkerConfig> config_;
  std::mutex config_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<WorkerDynamicConfig>> reconfigure_server_;
  WorkerData data_;
  Inbox<worker_types::InSpeed> in_speed_;
  Inbox<worker_types::InCounter> in_counter_;
  ros::Publisher out_counter_;
  ros::Publisher out_status_;
  std::vector<std::pair<std::string, std::function<bool()>>> servers_;
  ros::WallTimer timer_;
  std::unique_ptr<WorkerImpl> impl_;
  bool configured_ = false;
  std::list<CallbackThread> threads_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  std::vector<std::shared_ptr<void>> action_servers_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "worker");
  all_kinds::set_log_level();
  try {
    return all_kinds::WorkerNode().run() ? 0 : 1;
  } catch (const std::exception & error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
