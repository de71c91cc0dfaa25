// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node clerk: its life-cycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in clerk_impl.cpp.

#include <cstdint>
#include <exception>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "action_server.hpp"
#include "callback_thread.hpp"
#include "parameters.hpp"
#include "ros/ros.h"
#include "ros_log.hpp"
#include "serving/clerk_impl.hpp"
#include "serving/clerk_interface.hpp"

namespace serving
{

/// A node that calls its logic back from its start to its end.
class ClerkNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  ClerkNode()
  {
    read_parameters();
    connect_senders();
  }

  ClerkNode(const ClerkNode &) = delete;
  ClerkNode & operator=(const ClerkNode &) = delete;

  /// Destroy subscriptions and servers, then clean up the logic.
  ~ClerkNode()
  {
    spinner_.stop();
    action_servers_.clear();
    services_.clear();
    threads_.clear();
    if (configured_) {
      impl_->cleanup();
    }
  }

  /// Configure the logic and serve until shutdown.
  bool run()
  {
    if (!impl_->configure(*config_)) {
      ROS_FATAL("The logic rejected its configuration.");
      return false;
    }
    configured_ = true;
    connect_receivers();
    spinner_.start();
    ros::waitForShutdown();
    return true;
  }

private:
  void read_parameters()
  {
    ClerkConfig config;
    read_parameter(private_, "greeting", config.greeting);
    read_parameter(private_, "patience", config.patience);
    config_ = std::make_shared<ClerkConfig>(config);
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    ClerkPassthrough passthrough;
    passthrough.log = Logger(write_log);
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    impl_ = std::make_unique<ClerkImpl>(passthrough);
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    serve<clerk_types::GreetService>(
      node_,
      "greet",
      &ClerkImpl::serve_greet);
    serve<clerk_types::OpenService>(
      private_,
      "open",
      &ClerkImpl::serve_open);
    serve_action<clerk_types::CountAction>(
      node_,
      "count",
      &ClerkImpl::execute_count);
  }

  /// Create a service server.
  template<typename Service>
  void serve(
    const ros::NodeHandle & node,
    const std::string & name,
    void (ClerkImpl::* answer)(
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
    void (ClerkImpl::* execute)(Goal<Action> &))
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
  std::shared_ptr<const ClerkConfig> config_;
  std::unique_ptr<ClerkImpl> impl_;
  bool configured_ = false;
  std::list<CallbackThread> threads_;
  std::vector<ros::ServiceServer> services_;
  std::vector<std::shared_ptr<void>> action_servers_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace serving

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "clerk");
  serving::set_log_level();
  try {
    return serving::ClerkNode().run() ? 0 : 1;
  } catch (const std::exception & error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
