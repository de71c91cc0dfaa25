// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node controller: its lifecycle and its ROS interfaces.
// Generated from driving.ros_package.
// The logic is in controller_impl.cpp.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "driving/controller_impl.hpp"
#include "driving/controller_interface.hpp"
#include "ros/callback_thread.hpp"
#include "ros/clock.hpp"
#include "ros/inbox.hpp"
#include "ros/loop.hpp"
#include "ros/parameters.hpp"
#include "ros/process.hpp"
#include "ros/receiver.hpp"
#include "ros/ros.h"
#include "ros/ros_log.hpp"
#include "ros/sending.hpp"
#include "ros/supervisor.hpp"

namespace driving
{

constexpr double FREQUENCY = 100.0;  // Hz

/// The node and its life: configure, activate, update until it stops, deactivate, cleanup.
class ControllerNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit ControllerNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  ControllerNode(const ControllerNode &) = delete;
  ControllerNode & operator=(const ControllerNode &) = delete;

  ~ControllerNode()
  {
    spinner_.stop();
  }

  /// Go through the lifecycle, in the thread of the logic.
  void live()
  {
    if (!supervisor_.step("configure", [this] {return impl_->configure(*config_);})) {
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
    ControllerConfig config;
    read_parameter(private_, "speed_limit", config.speed_limit);
    config_ = std::make_shared<ControllerConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ControllerPassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    out_speed_ = node_.advertise<controller_types::OutSpeed>(
      "speed",
      10);
    impl_ = std::make_unique<ControllerImpl>(passthrough);
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
      "target_speed",
      in_target_speed_);
    serve<controller_types::StopService>(
      node_,
      "stop",
      "serve_stop",
      &ControllerImpl::serve_stop);
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
    data_.in_target_speed_updated = in_target_speed_.take(data_.in_target_speed);
    data_.out_speed_active = true;
    const bool returned = supervisor_.step(
      "update", [this] {impl_->update(data_, *config_); return true;});
    if (!returned) {
      return;
    }
    if (data_.out_speed_active) {
      out_speed_.publish(data_.out_speed);
    }
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
    void (ControllerImpl::* answer)(
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

  Supervisor & supervisor_;
  Logger log_{write_log};
  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  Clock clock_{node_, supervisor_.waits()};
  std::shared_ptr<const ControllerConfig> config_;
  Loop loop_{clock_, FREQUENCY};
  ControllerData data_;
  Inbox<controller_types::InTargetSpeed> in_target_speed_;
  ros::Publisher out_speed_;
  std::unique_ptr<ControllerImpl> impl_;
  std::vector<std::shared_ptr<Receiver>> receivers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace driving

int main(int argc, char ** argv)
{
  return driving::run_node<driving::ControllerNode>(argc, argv, "controller");
}
