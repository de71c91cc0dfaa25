// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in clerk_impl.cpp.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ros/action_server.hpp"
#include "ros/callback_thread.hpp"
#include "ros/clock.hpp"
#include "ros/parameters.hpp"
#include "ros/process.hpp"
#include "ros/receiver.hpp"
#include "ros/ros.h"
#include "ros/ros_log.hpp"
#include "ros/sending.hpp"
#include "ros/supervisor.hpp"
#include "serving/clerk_impl.hpp"
#include "serving/clerk_interface.hpp"

namespace serving
{

/// The node and its life: configure, activate, serve until it stops, deactivate, cleanup.
class ClerkNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit ClerkNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  ClerkNode(const ClerkNode &) = delete;
  ClerkNode & operator=(const ClerkNode &) = delete;

  ~ClerkNode()
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
    ClerkConfig config;
    read_parameter(private_, "greeting", config.greeting);
    read_parameter(private_, "patience", config.patience);
    config_ = std::make_shared<ClerkConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ClerkPassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    impl_ = std::make_unique<ClerkImpl>(passthrough);
  }

  /// Receive and serve until the node stops.
  void work()
  {
    if (!supervisor_.stopping()) {
      supervisor_.guard("connect_receivers", [this] {connect_receivers();});
    }
    supervisor_.wait_for_stop();
    stop_receivers();
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    serve<clerk_types::GreetService>(
      node_,
      "greet",
      "serve_greet",
      &ClerkImpl::serve_greet);
    serve<clerk_types::OpenService>(
      private_,
      "open",
      "serve_open",
      &ClerkImpl::serve_open);
    serve_action<clerk_types::CountAction>(
      node_,
      "count",
      "execute_count",
      GoalPolicy::replace,
      &ClerkImpl::execute_count);
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

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    const std::string & method,
    void (ClerkImpl::* answer)(
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
    void (ClerkImpl::* execute)(Goal<Action> &))
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
  std::shared_ptr<const ClerkConfig> config_;
  std::unique_ptr<ClerkImpl> impl_;
  std::vector<std::shared_ptr<Receiver>> receivers_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace serving

int main(int argc, char ** argv)
{
  return serving::run_node<serving::ClerkNode>(argc, argv, "clerk");
}
