// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The node contact_evaluate: its life-cycle and its ROS interfaces.
// Generated from contact_analysis.ros_package.
// The logic is in contact_evaluate_impl.cpp.

#include <cstdint>
#include <exception>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "action_server.hpp"
#include "callback_thread.hpp"
#include "contact_analysis/ContactEvaluateDynamicConfig.h"
#include "contact_analysis/contact_evaluate_impl.hpp"
#include "contact_analysis/contact_evaluate_interface.hpp"
#include "dynamic_reconfigure/server.h"
#include "inbox.hpp"
#include "parameters.hpp"
#include "ros/ros.h"
#include "ros_log.hpp"
#include "ros_publisher.hpp"

namespace contact_analysis
{

constexpr double FREQUENCY = 1000.0;  // Hz
constexpr std::uint32_t QUEUE = 10;  // messages kept for a topic

/// A node that runs its logic at a fixed frequency until shutdown.
class ContactEvaluateNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  ContactEvaluateNode()
  {
    read_parameters();
    connect_senders();
  }

  ContactEvaluateNode(const ContactEvaluateNode &) = delete;
  ContactEvaluateNode & operator=(const ContactEvaluateNode &) = delete;

  /// Destroy subscriptions and servers, then clean up the logic.
  ~ContactEvaluateNode()
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
    ContactEvaluateConfig config;
    read_parameter(private_, "samples", config.samples);
    read_parameter(private_, "pub_sample", config.pub_sample);
    config_ = std::make_shared<ContactEvaluateConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ContactEvaluatePassthrough passthrough;
    passthrough.log = Logger(write_log);
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.pub_plot_learn_cop = advertise<contact_evaluate_types::PubPlotLearnCop>(
      node_,
      "plot_learn_cop");
    impl_ = std::make_unique<ContactEvaluateImpl>(passthrough);
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    reconfigure_server_ =
      std::make_unique<dynamic_reconfigure::Server<ContactEvaluateDynamicConfig>>(private_);
    reconfigure_server_->setCallback(
      [this](const ContactEvaluateDynamicConfig & values, std::uint32_t) {
        reconfigure(values);
      });
    subscribe(
      node_,
      "cop",
      in_cop_);
    serve<contact_evaluate_types::LoadService>(
      node_,
      "load",
      &ContactEvaluateImpl::serve_load);
    serve<contact_evaluate_types::StoreService>(
      node_,
      "store",
      &ContactEvaluateImpl::serve_store);
    serve_action<contact_evaluate_types::LearnAction>(
      node_,
      "learn",
      &ContactEvaluateImpl::execute_learn);
    serve_action<contact_evaluate_types::EvaluateAction>(
      node_,
      "evaluate",
      &ContactEvaluateImpl::execute_evaluate);
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_cop_updated = in_cop_.take(data_.in_cop);
    impl_->update(data_, *current_config());
  }

  /// Update the configuration with the changed parameters.
  void reconfigure(const ContactEvaluateDynamicConfig & values)
  {
    const auto config = std::make_shared<ContactEvaluateConfig>(*current_config());
    config->pub_sample = values.pub_sample;
    const std::lock_guard<std::mutex> lock(config_mutex_);
    config_ = config;
  }

  std::shared_ptr<const ContactEvaluateConfig> current_config()
  {
    const std::lock_guard<std::mutex> lock(config_mutex_);
    return config_;
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

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    void (ContactEvaluateImpl::* answer)(
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
    void (ContactEvaluateImpl::* execute)(Goal<Action> &))
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
  std::shared_ptr<const ContactEvaluateConfig> config_;
  std::mutex config_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<ContactEvaluateDynamicConfig>> reconfigure_server_;
  ContactEvaluateData data_;
  Inbox<contact_evaluate_types::InCop> in_cop_;
  std::unique_ptr<ContactEvaluateImpl> impl_;
  bool configured_ = false;
  std::list<CallbackThread> threads_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  std::vector<std::shared_ptr<void>> action_servers_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace contact_analysis

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "contact_evaluate");
  contact_analysis::set_log_level();
  try {
    return contact_analysis::ContactEvaluateNode().run() ? 0 : 1;
  } catch (const std::exception & error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
