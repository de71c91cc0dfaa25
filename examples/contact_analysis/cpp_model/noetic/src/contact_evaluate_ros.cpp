// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The node contact_evaluate: its lifecycle and its ROS interfaces.
// Generated from contact_analysis.ros_package.
// The logic is in contact_evaluate_impl.cpp.

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contact_analysis/ContactEvaluateDynamicConfig.h"
#include "contact_analysis/contact_evaluate_impl.hpp"
#include "contact_analysis/contact_evaluate_interface.hpp"
#include "dynamic_reconfigure/server.h"
#include "ros/action_server.hpp"
#include "ros/callback_thread.hpp"
#include "ros/clock.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/parameters.hpp"
#include "ros/process.hpp"
#include "ros/receiver.hpp"
#include "ros/ros.h"
#include "ros/ros_log.hpp"
#include "ros/ros_publisher.hpp"
#include "ros/sending.hpp"
#include "ros/supervisor.hpp"

namespace contact_analysis
{

constexpr double FREQUENCY = 1000.0;  // Hz

/// The node and its life: configure, activate, update until it stops, deactivate, cleanup.
class ContactEvaluateNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit ContactEvaluateNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  ContactEvaluateNode(const ContactEvaluateNode &) = delete;
  ContactEvaluateNode & operator=(const ContactEvaluateNode &) = delete;

  ~ContactEvaluateNode()
  {
    spinner_.stop();
  }

  /// Go through the lifecycle, in the thread of the logic.
  void live()
  {
    if (!supervisor_.step("configure", [this] {return impl_->configure(*current_config());})) {
      supervisor_.refuse("The logic refused to configure.");
      return;
    }
    supervisor_.set_state("inactive");
    const auto activate = [this] {return impl_->activate();};
    if (!supervisor_.stopping() && supervisor_.step("activate", activate)) {
      supervisor_.set_state("active");
      work();
      supervisor_.set_state("deactivating");
      supervisor_.waits().clear();
      supervisor_.step("deactivate", [this] {impl_->deactivate(); return true;});
    } else {
      supervisor_.refuse("The logic refused to activate.");
    }
    supervisor_.set_state("cleaning up");
    supervisor_.waits().clear();
    supervisor_.step("cleanup", [this] {impl_->cleanup(); return true;});
  }

  /// Abort the goals whose execution does not end.
  void abort_goals()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
      receiver->abandon();
    }
  }

private:
  void read_parameters()
  {
    supervisor_.set_stop_timeout(private_.param("stop_timeout", 2.0));
    ContactEvaluateConfig config;
    read_parameter(private_, "samples", config.samples);
    read_parameter(private_, "pub_sample", config.pub_sample);
    config_ = std::make_shared<ContactEvaluateConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ContactEvaluatePassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    passthrough.pub_plot_learn_cop = advertise<contact_evaluate_types::PubPlotLearnCop>(
      node_,
      "plot_learn_cop",
      10);
    reconfigure_server_ =
      std::make_unique<dynamic_reconfigure::Server<ContactEvaluateDynamicConfig>>(private_);
    reconfigure_server_->setCallback(
      [this](const ContactEvaluateDynamicConfig & values, std::uint32_t) {
        reconfigure(values);
      });
    impl_ = std::make_unique<ContactEvaluateImpl>(passthrough);
  }

  /// Receive and update until the node stops.
  void work()
  {
    if (!supervisor_.stopping()) {
      supervisor_.guard("connect_receivers", [this] {connect_receivers();});
    }
    loop_.run(supervisor_, log_, [this] {update();});
    stop_receivers();
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    subscribe(
      node_,
      "cop",
      in_cop_);
    serve<contact_evaluate_types::LoadService>(
      node_,
      "load",
      "serve_load",
      &ContactEvaluateImpl::serve_load);
    serve<contact_evaluate_types::StoreService>(
      node_,
      "store",
      "serve_store",
      &ContactEvaluateImpl::serve_store);
    serve_action<contact_evaluate_types::LearnAction>(
      node_,
      "learn",
      "execute_learn",
      GoalPolicy::replace,
      &ContactEvaluateImpl::execute_learn);
    serve_action<contact_evaluate_types::EvaluateAction>(
      node_,
      "evaluate",
      "execute_evaluate",
      GoalPolicy::replace,
      &ContactEvaluateImpl::execute_evaluate);
  }

  /// Wait for the callbacks to return. Subscriptions and servers last as long as the node: it takes
  /// an answer of the master to destroy them.
  void stop_receivers()
  {
    for (const auto & receiver : receivers_) {
      receiver->stop();
    }
    std::string late;
    for (const auto & receiver : receivers_) {
      if (!receiver->wait_until(supervisor_.deadline())) {
        late += (late.empty() ? "" : ", ") + receiver->name();
        receiver->abandon();
      }
    }
    if (!late.empty()) {
      supervisor_.report_late(late);
      return;
    }
    wait_for_sending();  // the last responses and results
  }

  /// Run one cycle: take the latest messages, call update, publish the active outputs.
  void update()
  {
    data_.in_cop_updated = in_cop_.take(data_.in_cop);
    supervisor_.step("update", [this] {impl_->update(data_, *current_config()); return true;});
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
  std::shared_ptr<Publisher<Message>> advertise(
    ros::NodeHandle & node,
    const std::string & topic,
    std::uint32_t queue_size,
    bool latch = false)
  {
    return std::make_shared<RosPublisher<Message>>(
      node.advertise<Message>(topic, queue_size, latch));
  }

  /// Subscribe to a topic whose latest message is an input of the next cycle.
  template<typename Message>
  void subscribe(
    ros::NodeHandle & node,
    const std::string & topic,
    const Inbox<Message> & inbox,
    std::uint32_t queue_size = 10,
    const ros::TransportHints & hints = ros::TransportHints())
  {
    subscribers_.push_back(
      node.subscribe<Message, const boost::shared_ptr<Message> &>(
        topic,
        queue_size,
        [inbox](const boost::shared_ptr<Message> & message) {
          inbox.put(message);
        },
        ros::VoidConstPtr(),
        hints));
  }

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    void (ContactEvaluateImpl::* answer)(
      const typename Service::Request &,
      typename Service::Response &))
  {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    const auto thread = std::make_shared<CallbackThread>(node, name);
    receivers_.push_back(thread);
    services_.push_back(
      thread->node().advertiseService<Request, Response>(
        name,
        [this, method, answer](auto & request, auto & response) {
          return supervisor_.guard(
            method, [&] {
              (impl_.get()->*answer)(request, response);
            });
        }));
  }

  /// Create an action server.
  template<typename Action>
  void serve_action(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    GoalPolicy policy,
    void (ContactEvaluateImpl::* execute)(Goal<Action> &))
  {
    receivers_.push_back(
      std::make_shared<ActionServer<Action>>(
        node,
        name,
        method,
        policy,
        supervisor_,
        [this, execute](auto & goal) {
          (impl_.get()->*execute)(goal);
        }));
  }

  Supervisor & supervisor_;
  Logger log_{write_log};
  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  Clock clock_{node_, supervisor_.waits()};
  std::shared_ptr<const ContactEvaluateConfig> config_;
  std::mutex config_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<ContactEvaluateDynamicConfig>> reconfigure_server_;
  Loop loop_{clock_, FREQUENCY};
  ContactEvaluateData data_;
  Inbox<contact_evaluate_types::InCop> in_cop_;
  std::unique_ptr<ContactEvaluateImpl> impl_;
  std::vector<std::shared_ptr<Receiver>> receivers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace contact_analysis

int main(int argc, char ** argv)
{
  return contact_analysis::run_node<contact_analysis::ContactEvaluateNode>(
    argc,
    argv,
    "contact_evaluate");
}
